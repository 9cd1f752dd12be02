// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The map of a super-step of an impulse coupling, against runs of the same scenario.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "long_run.hpp"
#include "refusal.hpp"
#include "tandem/stability/fast_period.hpp"
#include "tandem/stability/largest_step.hpp"
#include "tandem/stability/modes.hpp"

namespace tandem::stability_tests {
namespace {

using namespace test;

scenario::Scenario by_impulse(double ratio, const Settings& more = {}) {
  Settings all = {fmt::format("parameters.frequency_ratio={}", ratio)};
  all.insert(all.end(), more.begin(), more.end());
  return scene("two_mass/impulse.toml", all);
}

const Settings heavy = {"parameters.c23_over_c21=-10", "coordination.coupling=impulse_stiffness"};

/// What stands after so many super-steps of a run, as its subsystems tell it.
VectorXd after(scenario::Scenario one, const SuperStep& step, int super_steps) {
  one.stop = one.start + super_steps * step.period;
  scenario::Assembly run(one, sources());
  run.initialize();
  while (run.coordinator().round()) {
  }
  VectorXd z(static_cast<Eigen::Index>(step.coordinates.size()));
  for (std::size_t k = 0; k < step.coordinates.size(); ++k) {
    const Coordinate& c = step.coordinates[k];
    const Subsystem& subsystem = run.subsystem(c.subsystem);
    std::vector<double> states(subsystem.states()->size());
    subsystem.get_states(states);
    const History& history = run.coordinator().exchange().history(c.subsystem);
    const auto at = static_cast<std::size_t>(c.index);
    z[static_cast<Eigen::Index>(k)] = c.age < 0 ? states[at] : history.values(history.newest() - c.age)[at];
  }
  return z;
}

TEST(StabilityOfImpulse, TheMapMovesWhatStandsInARunAsTheRunDoes) {
  for (const Settings& more : {Settings(), heavy})
    for (const double ratio : {1.5, 7.0, 25.0, 62.5, 101.0, 300.0}) {
      const auto one = by_impulse(ratio, more);
      const SuperStep step = stability::super_step(one, sources());
      EXPECT_TRUE(step.linear);
      const VectorXd from = after(one, step, 12), to = after(one, step, 13);
      EXPECT_LE((step.map * from - to).norm(), 1e-11 * to.norm()) << ratio << ' ' << more.size();
    }
}

}  // namespace
}  // namespace tandem::stability_tests
