// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The map of a super-step of an impulse coupling, against runs of the same scenario.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "long_run.hpp"
#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/stability/fast_period.hpp"
#include "tandem/stability/largest_step.hpp"
#include "tandem/stability/modes.hpp"

namespace tandem::stability_tests {
namespace {

using namespace test;

const char* const inner_mechanism = R"toml(
name = "two"
dimension = 2
[parameters]
m = { value = 1, unit = "kg" }
w = { value = 1, unit = "rad/s" } # of the slow side as a whole
times = { value = 1, unit = "1" }
[points]
O = { at = [-10, 0], fixed = true }
P = { at = [20, 0] }
Q = { at = [10, 0] }
[masses]
p = { point = "P", mass = "$m" }
q = { point = "Q", mass = "$(9*m)" }
[springs]
inner = { points = ["Q", "P"], stiffness = "$(0.9*m*(times*w)^2)", free = 10 }
ground = { points = ["O", "Q"], stiffness = "$(10*m*w^2)", free = 20 }
[inputs.F]
unit = "N"
[forces.push]
point = "P"
direction = [1, 0]
magnitude = "F"
[outputs.x]
position = "P.x"
[run]
step = 1
formulation = "null_space"
integrator = "newmark"
)toml";

const char* const inner_scene = R"toml(
name = "inner"
[constants]
times = 10
w1 = 6.283185307179586
[subsystems.fast]
source = "builtin:two_mass.fast_force"
parameters = { frequency_ratio = 100 }
[subsystems.slow]
source = "mechanism:two.toml"
parameters = { m = "$(101/(0.9999*w1^2))", w = "$(w1/100)", times = "$times" }
[[connections]]
from = "fast.F"
to = "slow.F"
[[connections]]
from = "slow.x"
to = "fast.x2"
offset = -10
[[links]]
effort = "fast.F"
displacement = "slow.x"
[coordination]
coupling = "impulse"
[span]
stop = 100.0
)toml";

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
  const Settings beside = {"coordination.carrier=surrogate"};
  for (const Settings& more : {Settings(), heavy, beside})
    for (const double ratio : {1.5, 7.0, 25.0, 62.5, 101.0, 300.0}) {
      const auto one = by_impulse(ratio, more);
      const SuperStep step = stability::super_step(one, sources());
      EXPECT_TRUE(step.linear);
      const VectorXd from = after(one, step, 12), to = after(one, step, 13);
      EXPECT_LE((step.map * from - to).norm(), 1e-11 * to.norm()) << ratio << ' ' << more.size();
    }
}

/// Of the closed form: both frequencies, and the fast one goes on as it is. 3e-4 is the trapezoidal rule's error of the slow one.
TEST(StabilityOfImpulse, ModesAreThoseOfTheSystemUndivided) {
  for (const Settings& more : {Settings(), heavy})
    for (const double ratio : {25.0, 62.5, 300.0}) {
      const auto found = stability::stability(by_impulse(ratio, more), sources());
      ASSERT_EQ(found.modes.size(), 2U) << found.unknown;
      EXPECT_NEAR(found.modes[0].frequency, 1.0, 1e-6);
      EXPECT_NEAR(found.modes[1].frequency, 1.0 / ratio, 1e-8);
      for (const auto& mode : found.modes) {
        EXPECT_TRUE(mode.is_kept()) << ratio;
        EXPECT_NEAR(mode.detuning(), 0.0, 4e-4) << ratio << ' ' << mode.frequency;
        EXPECT_NEAR(mode.growth, 1.0, 2e-5) << ratio << ' ' << mode.frequency;
      }
    }
}

/// What is found to grow does so in a run. At mass ratio 1, without stiffness and with 20 steps a cycle, that is much.
TEST(StabilityOfImpulse, AHeavyFastSideGrowsAsTheRadiusSays) {
  const auto one =
      by_impulse(60.0, {"parameters.c23_over_c21=-10", "parameters.steps_per_cycle=20",
                        "coordination.coupling=impulse_stiffness", "coordination.carrier=surrogate"});
  const SuperStep step = stability::super_step(one, sources());
  ASSERT_GT(step.radius(), 1.001);
  const Eigen::EigenSolver<Eigen::MatrixXd> left(step.map.transpose());
  Eigen::Index most;
  left.eigenvalues().cwiseAbs().maxCoeff(&most);
  const Eigen::VectorXcd way = left.eigenvectors().col(most);
  const auto at = [&](int k) { return std::abs(way.conjugate().dot(after(one, step, k))); };
  EXPECT_NEAR(std::log(at(1500) / at(500)) / 1000.0, std::log(step.radius()), 1e-6);
}

/// Of fast sides of mass m on a spring between them the coupled frequency is known.
TEST(StabilityOfImpulse, FindsTheFastPeriodThatIsNotStated) {
  for (const double ratio : {1.5, 60.0, 1000.0}) {
    auto one = by_impulse(ratio);
    one.fast_period = 0.0;
    const auto found = stability::with_fast_period(one, sources());
    EXPECT_NEAR(found.fast_period, 1.0, 1e-6) << ratio;
    EXPECT_FALSE(scenario::lacks_fast_period(found));
    EXPECT_EQ(found.taken.size(), 1U);
  }
}

/// At ratio 100 the fast mode's multiplier is 1, as those of offsets are; a map does not know the time.
TEST(StabilityOfImpulse, IsTheSameFromAnyStartAndAtAnyMultiplier) {
  const auto found = [](const scenario::Scenario& one) {
    const auto all = stability::stability(one, sources());
    EXPECT_EQ(all.modes.size(), 2U) << all.unknown;
    for (const auto& mode : all.modes) EXPECT_NEAR(mode.detuning(), 0.0, 4e-4) << mode.frequency;
    return all;
  };
  const double radius = found(by_impulse(62.5)).radius,
               damping = found(by_impulse(62.5)).modes[0].scheme_damping;
  for (const double start : {0.1, -0.3333, 0.6, 3.0, 7.0, -30.0, 1000.0}) {
    auto one = by_impulse(62.5);
    one.start = start, one.stop = start + 300.0;
    const auto here = found(one);
    EXPECT_NEAR(here.radius, radius, 1e-9) << start;
    EXPECT_NEAR(here.modes[0].scheme_damping, damping, 1e-10) << start;
  }
  for (const double ratio : {62.5000001, 62.49999, 100.0 / 3.0, 33.3333333333})
    EXPECT_NEAR(found(by_impulse(ratio)).modes[0].scheme_damping, 0.0, 1e-5) << ratio;
  for (const auto& [ratio, steps] : {std::pair("100", "100"), {"400", "200"}, {"1000", "1000"}})
    for (const Settings& more : {Settings(), heavy}) {
      Settings all = more;
      all.push_back(std::string("parameters.steps_per_cycle=") + steps);
      const auto here = found(by_impulse(std::stod(ratio), all));
      EXPECT_NEAR(here.modes[0].growth, 1.0, 1e-5) << ratio;
    }
}

/// A mass on a spring within the slow side, of 10 and of 20 times its frequency: the surrogate lacks it.
TEST(StabilityOfImpulse, TellsOfAnInnerModeThatTheSurrogateLacks) {
  const Scratch folder;
  folder.write("two.toml", inner_mechanism);
  folder.write("s.toml", inner_scene);
  const auto growth = [&](const char* times) {
    const auto one = scenario::read(folder.path() / "s.toml", {std::string("constants.times=") + times});
    const auto all = stability::stability(stability::with_fast_period(one, sources()), sources());
    EXPECT_NEAR(all.modes.at(1).frequency, 0.01 * std::stod(times), 0.01 * 0.01 * std::stod(times));
    return all.modes.at(1).growth;
  };
  EXPECT_NEAR(growth("10"), 1.00028, 5e-5);
  EXPECT_NEAR(growth("20"), 1.00265, 2e-4);
}

TEST(StabilityOfImpulse, SearchesForNoLargestStep) {
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"grows and dies out by turns"},
                      [] { stability::largest_step(by_impulse(60.0), sources()); }));
}

TEST(StabilityOfImpulse, RefusesASurrogateThatKeepsItsStates) {
  const auto pendulum =
      scene("pushed_pendulum/pushed_pendulum.toml", {"coordination.coupling=impulse_taylor"});
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"slow_surrogate", "keeps its states to itself"},
                      [&] { stability::super_step(pendulum, sources()); }));
}

}  // namespace
}  // namespace tandem::stability_tests
