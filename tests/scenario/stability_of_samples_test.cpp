// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Maps of super-steps in which subsystems sample, against matrix exponentials and long runs.
#include <gtest/gtest.h>

#include <cmath>

#include "refusal.hpp"
#include "sampled_loop.hpp"
#include "tandem/stability/largest_step.hpp"
#include "tandem/stability/modes.hpp"

namespace tandem::stability_of_samples_tests {
namespace {

using namespace test;

TEST(StabilityOfSamples, TheRadiusOfASampledLoopIsThatOfItsMatrixExponentials) {
  std::mt19937_64 random(7);
  int unstable = 0;
  for (int k = 0; k < 60; ++k) {
    const Gains gains = gains_by_chance(random, k, 0.0, 1.0);
    const Scratch folder;
    const auto one = scene_of(folder, {part_of_period(k) * gains.period}, 0.0,
                              k % 5 == 0 ? "parallel" : "slowest-first", 5.0);
    const SuperStep step = stability::super_step(one, with_controller(gains));
    EXPECT_TRUE(step.linear);
    const double per_period = std::pow(radius_of(step.map), gains.period / step.period),
                 expected = exact_radius(gains);
    EXPECT_NEAR(per_period, expected, 1e-9 * expected) << k;
    unstable += expected > 1.0;
  }
  EXPECT_GT(unstable, 10);
  EXPECT_LT(unstable, 50);
}

/// Growth of both positions over a super-step, in the second half of a long run.
double growth_in(scenario::Scenario one, const Builtins& all, const SuperStep& step, double expected) {
  const int length = static_cast<int>(std::clamp(200.0 / std::abs(expected), 60.0, 8000.0)),
            part = length / 4;
  one.stop = one.start + length * step.period;
  scenario::Assembly run(one, all);
  test::Recording rows;
  run.coordinator().observe(&rows);
  run.initialize();
  while (run.coordinator().round()) {
  }
  const auto largest = [&](double from, double to) {
    double most = 0.0;
    for (int side = 0; side < 2; ++side)
      for (const auto& row : rows.rows(side))
        if (row[0] > from && row[0] <= to) most = std::max(most, std::abs(row[2]));
    return std::log(most);
  };
  const double end = one.stop, window = part * step.period;
  return (largest(end - window, end) - largest(end - 2.0 * window, end - window)) / part;
}

TEST(StabilityOfSamples, CoupledSidesWithAControllerGrowAsTheRadiusSays) {
  std::mt19937_64 random(11);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  const char* const schedules[] = {"slowest-first", "fastest-first", "parallel"};
  int checked = 0;
  for (int k = 0; k < 30; ++k) {
    const double period = between(0.2, 0.8);
    const Gains gains{between(0.0, 6.0),
                      between(0.0, 1.0),
                      between(0.0, 1.0),
                      period,
                      0.0,
                      k % 2 == 0 ? 0.0 : 0.3 * period};
    const auto all = with_controller(gains);
    const Scratch folder;
    const auto one = scene_of(folder, {period / (1 + k % 3), period / (1 + k % 2)}, between(0.2, 2.0),
                              schedules[k % 3], 5.0);
    const SuperStep step = stability::super_step(one, all);
    const double expected = std::log(radius_of(step.map));
    if (std::abs(expected) < 3e-3) continue;  // as long a run as that takes
    ++checked;
    EXPECT_NEAR(growth_in(one, all, step, expected), expected, 0.02 * std::abs(expected) + 1e-4) << k;
  }
  EXPECT_GT(checked, 20);
}

/// The same controller in C++ and as a diagram, which begins one period later and whose start depends on its input.
TEST(StabilityOfSamples, TheDriveHasTheSameRadiusWithEitherController) {
  const auto radius = [](const Settings& settings) {
    return radius_of(stability::super_step(scene("drive/drive_libraries.toml", settings), sources()).map);
  };
  const double expected = radius({});
  EXPECT_NEAR(radius({"subsystems.controller.source=diagram:controller.toml"}), expected, 1e-9);
  EXPECT_LT(expected, 0.98);
  EXPECT_GT(radius({"subsystems.controller.parameters.kp=120"}), 1.0);
}

/// A weight that comes once is sampled in 1 s. It reads nobody, and takes no part in the super-step.
TEST(StabilityOfSamples, WhatReadsNobodyMovesNothing) {
  const auto modes = [](const char* file, double period) {
    const auto found = stability::stability(scene(file, {}), sources());
    EXPECT_EQ(found.unknown, "");
    EXPECT_NEAR(found.step.period, period, 1e-12);
    return found.modes;
  };
  const auto with = modes("drive/drive_mechanism.toml", 2.5e-3),
             without = modes("drive/drive_libraries.toml", 2.5e-3);
  ASSERT_EQ(with.size(), without.size()) << "the mechanism has an angle more, at rest";
  for (std::size_t k = 0; k < without.size(); ++k) EXPECT_NEAR(with[k].growth, without[k].growth, 1e-6);
}

/// What grows slowly beside a short super-step is not at rest.
TEST(StabilityOfSamples, AnUnstableLoopIsToldAtAnyStep) {
  for (const double period : {0.2, 0.002, 2e-4}) {
    const Scratch folder;
    const auto one = scene_of(folder, {period}, 0.0, "slowest-first", 5.0);
    const Gains gains{-2.0, 0.0, 0.0, period, 0.0, 0.0};
    const auto found = stability::stability(one, with_controller(gains));
    EXPECT_NEAR(found.rate, std::log(exact_radius(gains)) / period, 1e-6) << period;
    EXPECT_GT(found.rate, 0.8);
    EXPECT_NEAR(std::log(found.radius), found.rate * found.step.period, 1e-7) << period;
  }
}

TEST(StabilityOfSamples, WhatStandsForASampledOneIsTold) {
  const Scratch folder;
  const auto one = scene_of(folder, {0.1}, 0.0, "slowest-first", 5.0);
  const auto found = stability::stability(one, with_controller({1.0, 0.1, 0.2, 0.3, 0.0, 0.0}));
  ASSERT_EQ(found.step.identified.size(), 1U);
  EXPECT_EQ(found.step.identified[0].name, "control");
  EXPECT_TRUE(found.step.identified[0].sampled);
  EXPECT_EQ(found.step.identified[0].order, 1);
  EXPECT_EQ(found.step.steps, (std::vector<std::int64_t>{3, 1}));
  const auto gains = Gains{2.0, 0.0, 0.0, 0.3, 0.0, 0.0};
  EXPECT_GT(stability::stability(one, with_controller(gains)).rate, 0.0) << "the sampled loop grows";
  const auto largest = stability::largest_step(one, with_controller(gains));
  EXPECT_GT(largest.factor, 1.0) << "but the scheme lets it grow no faster than it does";
  EXPECT_EQ(largest.smallest, 1.0);
  EXPECT_EQ(largest.whose, "side1") << "not that of the controller, which is longer";
  EXPECT_NEAR(largest.step, 0.1, 1e-12);
}

}  // namespace
}  // namespace tandem::stability_of_samples_tests
