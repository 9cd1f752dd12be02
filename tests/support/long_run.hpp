// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Runs that the map of a super-step is compared with.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "recording.hpp"
#include "sources/all.hpp"
#include "tandem/scenario/assembly.hpp"
#include "tandem/stability/super_step.hpp"

namespace tandem::test {

using Eigen::VectorXd;
using stability::Coordinate;
using stability::SuperStep;

inline const std::string scenes = TANDEM_SOURCE_DIR "/scenarios/";

using Settings = std::vector<std::string>;

inline scenario::Scenario scene(const std::string& file, const Settings& settings) {
  scenario::Scenario one = scenario::read(scenes + file, settings);
  one.coordination.start = StartKind::cold;
  one.coordination.diverged_beyond = std::numeric_limits<double>::infinity();
  return one;
}

inline const Builtins& sources() {
  static const Builtins all = all_sources();
  return all;
}

/// A run of so many super-steps, of subsystems whose states are outputs too, by the same names.
class LongRun {
 public:
  LongRun(scenario::Scenario scenario, const SuperStep& step, int super_steps) : step_(step) {
    scenario.stop = scenario.start + super_steps * step.period;
    scenario::Assembly run(scenario, sources());
    for (int i = 0; i < run.topology().size(); ++i) outputs_.push_back(run.topology().output_names(i));
    run.coordinator().observe(&rows_);
    run.initialize();
    while (run.coordinator().round()) {
    }
  }

  /// What stands after k super-steps; before the first sample all are as that.
  VectorXd at(int k) const {
    VectorXd z(static_cast<Eigen::Index>(step_.coordinates.size()));
    for (std::size_t i = 0; i < step_.coordinates.size(); ++i) {
      const Coordinate& c = step_.coordinates[i];
      const auto& rows = rows_.rows(c.subsystem);
      const std::size_t newest = row_at(rows, k * step_.period);
      const auto& names = outputs_[static_cast<std::size_t>(c.subsystem)];
      const auto index = c.age < 0 ? std::find(names.begin(), names.end(), c.name) - names.begin() : c.index;
      const auto age = static_cast<std::size_t>(std::max(c.age, 0));
      z[static_cast<Eigen::Index>(i)] =
          rows[newest - std::min(newest, age)].at(static_cast<std::size_t>(Samples::header + index));
    }
    return z;
  }

 private:
  static std::size_t row_at(const Recording::Rows& rows, double t) {
    const auto near = [](const auto& row, double time) { return row[0] < time; };
    const auto it = std::lower_bound(rows.begin(), rows.end(), t - 1e-9 * std::max(1.0, t), near);
    EXPECT_TRUE(it != rows.end() && std::abs((*it)[0] - t) < 1e-9 * std::max(1.0, t)) << "no row at " << t;
    return static_cast<std::size_t>(it - rows.begin());
  }

  const SuperStep& step_;
  Recording rows_;
  std::vector<std::vector<std::string>> outputs_;
};

}  // namespace tandem::test
