// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The map of a super-step against runs of the same scenario: step by step, and how it grows in the long run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "long_run.hpp"
#include "refusal.hpp"
#include "tandem/nearest.hpp"
#include "tandem/stability/largest_step.hpp"
#include "tandem/stability/modes.hpp"

namespace tandem::stability_tests {
namespace {

using namespace test;

TEST(Stability, TheMapMovesWhatStandsInARunOfTwoMassesAsTheRunDoes) {
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const char* how :
         {"lagrange0", "lagrange1", "lagrange3", "lagrange4", "hermite", "least_squares2_3"})
      for (const double ratio : {1.5, 7.0, 25.0}) {
        const auto one =
            scene("two_mass/two_mass.toml", {"parameters.frequency_ratio=" + std::to_string(ratio),
                                             std::string("coordination.schedule=") + schedule,
                                             std::string("connections.reconstruction=") + how});
        const SuperStep step = stability::super_step(one, sources());
        EXPECT_TRUE(step.linear);
        const LongRun run(one, step, 14);
        for (const int k : {10, 12}) {
          const VectorXd from = run.at(k), to = run.at(k + 1);
          EXPECT_LE((step.map * from - to).norm(), 1e-12 * to.norm())
              << schedule << ' ' << how << ' ' << ratio;
        }
      }
}

TEST(Stability, TheMapKnowsMeansMatchedHoldsMemoryAndDelay) {
  const std::vector<std::pair<std::string, Settings>> all = {
      {"two_mass/two_mass.toml",
       {"coordination.schedule=fastest-first", "connections[1].reconstruction=mean"}},
      {"two_mass/two_mass.toml", {"connections.reconstruction=matched_hold"}},
      {"two_mass/staggered.toml", {}},
      {"two_mass/force_memory.toml", {}},
      {"two_mass/force_delay.toml", {}}};
  for (const auto& [file, settings] : all) {
    const auto one = scene(file, settings);
    const SuperStep step = stability::super_step(one, sources());
    const LongRun run(one, step, 14);
    const VectorXd from = run.at(11), to = run.at(12);
    EXPECT_LE((step.map * from - to).norm(), 1e-12 * to.norm()) << file;
  }
}

/// A scene of two oscillators of all kinds.
Settings any_oscillators(std::mt19937_64& random) {
  const auto between = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const auto one_of = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); };
  const auto text = [](const std::string& key, double value) {
    return key + "=" + fmt::format("{:.17g}", value);
  };
  Settings all = {text("constants.m2", std::exp(between(-2.0, 2.0))),
                  text("constants.c2", std::exp(between(-2.0, 2.0))),
                  text("constants.c", std::exp(between(-2.0, 2.0))),
                  text("constants.d1", between(0.0, 0.3)),
                  text("constants.d2", between(0.0, 0.3)),
                  text("constants.d", between(0.0, 0.3)),
                  "connections.reconstruction=lagrange" + std::to_string(one_of(4))};
  const double step = std::exp(between(-2.0, 0.5));
  all.push_back(text("constants.step", step));
  all.push_back(text("subsystems.side2.parameters.step", step / (1 + one_of(5))));
  const char* const schedules[] = {"slowest-first", "fastest-first", "parallel"};
  all.push_back(std::string("coordination.schedule=") + schedules[one_of(3)]);
  return all;
}

/// Growth of a super-step over the second half of a long run, in the logarithm.
double growth_in(const scenario::Scenario& one, const SuperStep& step, double expected) {
  constexpr double most = 300.0;  // in the logarithm: squares stay within a double
  const int length = static_cast<int>(std::clamp(most / std::abs(expected), 40.0, 20000.0)),
            part = length / 4;
  const LongRun run(one, step, length + 1);
  const auto largest = [&](int from) {
    double most = 0.0;
    for (int k = from; k < from + part; ++k) most = std::max(most, run.at(k).norm());
    return std::log(most);
  };
  return (largest(length - part) - largest(length - 2 * part)) / part;
}

TEST(Stability, RandomOscillatorsGrowAndDieOutAsTheRadiusSays) {
  std::mt19937_64 random(25);
  const char* const files[] = {"force_displacement", "displacement_displacement", "force_force"};
  int stable = 0, unstable = 0;
  for (int k = 0; k < 200; ++k) {
    Settings settings = any_oscillators(random);
    const std::string file = files[k % 3];
    if (file == "force_force") settings.back() = "coordination.schedule=parallel";
    const auto one = scene("oscillator/" + file + ".toml", settings);
    const SuperStep step = stability::super_step(one, sources());
    const double expected = std::log(step.radius());
    if (std::abs(expected) < 2e-3) continue;  // as long a run as that takes
    const double found = growth_in(one, step, expected);
    ++(expected > 0.0 ? unstable : stable);
    EXPECT_NEAR(found, expected, 0.01 * std::abs(expected)) << k << ' ' << file << ' ' << listed(settings);
  }
  EXPECT_GT(stable, 40);
  EXPECT_GT(unstable, 40);
}

TEST(Stability, ModesOfTheSystemUndividedAreThoseOfTheEquations) {
  const auto masses = stability::stability(scene("two_mass/two_mass.toml", {}), sources());
  ASSERT_EQ(masses.modes.size(), 2U) << masses.unknown;
  EXPECT_NEAR(masses.modes[0].frequency, 1.0, 1e-6);
  EXPECT_NEAR(masses.modes[1].frequency, 1.0 / 25.0, 1e-6);
  for (const auto& mode : masses.modes) EXPECT_NEAR(mode.damping, 0.0, 1e-6);
  EXPECT_EQ(masses.mostly(masses.modes[0]), "fast.x1, fast.v1");
  EXPECT_EQ(masses.mostly(masses.modes[1]), "slow.x2, slow.v2");
  // m = c = 1, d = 0.1: x1 + x2 has c and d, x1 - x2 has 3c and 3d
  const auto sides = stability::stability(scene("oscillator/force_displacement.toml", {}), sources());
  ASSERT_EQ(sides.modes.size(), 2U);
  for (const auto& [mode, times] : {std::pair{sides.modes[1], 1.0}, {sides.modes[0], 3.0}}) {
    const double ratio = 0.05 * std::sqrt(times);
    EXPECT_NEAR(mode.frequency, std::sqrt(times * (1.0 - ratio * ratio)) / (2.0 * std::numbers::pi), 1e-7);
    EXPECT_NEAR(mode.damping, ratio, 1e-7);
    EXPECT_NEAR(mode.scheme_frequency, mode.frequency, 1e-3 * mode.frequency);  // ten steps a radian
    EXPECT_GT(mode.likeness, 0.99);
  }
}

/// Both sides are exact and read polynomials, so that is all that detunes: of degree d by H^(d + 1).
TEST(Stability, DetuningAndDampingOfASchemeHaveItsOrder) {
  for (const int degree : {1, 2, 3}) {
    std::vector<double> far;
    for (const double step : {0.05, 0.025}) {
      const auto found =
          stability::stability(scene("oscillator/force_displacement.toml",
                                     {"constants.step=" + std::to_string(step),
                                      "connections.reconstruction=lagrange" + std::to_string(degree)}),
                               sources());
      const auto& mode = found.modes[0];
      far.push_back(std::hypot(mode.detuning(), mode.scheme_damping - mode.damping));
    }
    EXPECT_NEAR(std::log2(far[0] / far[1]), degree + 1.0, 0.2) << degree;
  }
}

/// Beside ratios that differ by 1e-5 and meet after a thousand of the slow side's steps.
TEST(Stability, StepsThatNeverMeetAreTakenWhereTheyNearlyDo) {
  for (const double ratio : {7.0710678118, 17.3205080757, 31.4159265359}) {
    const auto of = [](double r) {
      return scene("two_mass/two_mass.toml",
                   {fmt::format("parameters.frequency_ratio={:.17g}", r), "coordination.schedule=parallel",
                    "connections.reconstruction=lagrange1"});
    };
    const auto near = stability::stability(of(ratio), sources()),
               exact = stability::stability(of(std::round(ratio * 1000.0) / 1000.0), sources());
    EXPECT_GT(near.step.apart, 0.0) << ratio;
    EXPECT_LE(near.step.apart, 1e-3) << ratio;
    EXPECT_EQ(exact.step.apart, 0.0) << ratio;
    const auto& mode = exact.modes[0];
    EXPECT_NEAR(near.modes[0].scheme_damping, mode.scheme_damping,
                1e-5 + 0.005 * std::abs(mode.scheme_damping))
        << ratio;
    EXPECT_NEAR(near.modes[0].scheme_frequency, mode.scheme_frequency, 1e-3) << ratio;
  }
}

/// Own steps are differences of times: far from 0 their quotients are rounded, and no parameter had their value.
TEST(Stability, TheLargestStepIsTheSameWhereverTimeBegins) {
  for (const char* schedule : {"slowest-first", "parallel"}) {
    double first = 0.0;
    for (const double start : {0.0, 1.0, 17.3, -4.2, 1000.0}) {
      const Settings at = {"constants.step=0.013", "subsystems.side2.parameters.step=0.026",
                           std::string("coordination.schedule=") + schedule,
                           fmt::format("span.start={:.17g}", start),
                           fmt::format("span.stop={:.17g}", start + 10.0)};
      const auto one = scene("oscillator/displacement_displacement.toml", at);
      const auto largest = stability::largest_step(one, sources());
      const double step = largest.factor * largest.step;
      if (start == 0.0) first = step;
      EXPECT_NEAR(step, first, 1e-5 * first) << schedule << ' ' << start;
    }
    EXPECT_GT(first, 0.01) << schedule;
    EXPECT_LT(first, 1e3) << schedule;
  }
}

TEST(Stability, LargestStepsAreThoseOfTheSearch) {
  const auto of = [](const std::string& file, const Settings& settings) {
    return stability::largest_step(scene(file, settings), sources());
  };
  const Settings unit = {"constants.step=1",
                         "constants.d1=0.1",
                         "constants.d2=0.1",
                         "constants.d=0.1",
                         "coordination.schedule=parallel",
                         "connections.reconstruction=lagrange0"};
  const auto found = of("oscillator/force_displacement.toml", unit);
  EXPECT_EQ(found.whose, "communication step");
  EXPECT_EQ(found.step, 1.0);
  EXPECT_GT(found.factor, 0.0);
  for (const auto& [times, stable] : {std::pair(0.9999, true), {1.0001, false}}) {
    Settings near = unit;
    near[0] = "constants.step=" + fmt::format("{:.17g}", found.factor * times);
    const double radius =
        stability::super_step(scene("oscillator/force_displacement.toml", near), sources()).radius();
    EXPECT_EQ(radius <= 1.0 + 1e-9, stable) << times;
  }
  const auto masses = of("two_mass/two_mass.toml",
                         {"coordination.schedule=fastest-first", "connections.reconstruction=lagrange2"});
  EXPECT_EQ(masses.whose, "fast");
  for (const auto& [times, stable] : {std::pair(0.9999, true), {1.0001, false}}) {
    const std::string steps =
        fmt::format("parameters.steps_per_cycle={:.17g}", 100.0 / (masses.factor * times));
    const double radius =
        stability::super_step(
            scene("two_mass/two_mass.toml",
                  {"coordination.schedule=fastest-first", "connections.reconstruction=lagrange2", steps}),
            sources())
            .radius();
    EXPECT_EQ(radius <= 1.0 + 1e-9, stable) << times;
  }
}

}  // namespace
}  // namespace tandem::stability_tests
