// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What the two-mass test shows of the schemes, with its own integrators and 100 steps per cycle
// (docs/two_mass.md has the figures).
#include <gtest/gtest.h>

#include <cmath>

#include "two_mass/experiment.hpp"

namespace tandem::two_mass {
namespace {

Figures of(const std::string& schedule, const std::string& how, double ratio) {
  return run_case({{schedule, how, how}, ratio}).figures;
}

TEST(TwoMassTest, SlowestFirstOfDegreeThreeIsAccurateUpToTwentyFive) {
  for (const double ratio : {2.0, 5.0, 10.0, 15.0, 20.0, 25.0})
    EXPECT_LT(*of("slowest-first", "lagrange3", ratio).position_error, 0.021) << ratio;
  EXPECT_GT(*of("slowest-first", "lagrange3", 30.0).position_error, 0.025);
}

TEST(TwoMassTest, DegreeZeroIsBestOfTheExtrapolatingOnesFromTwentyFiveToFortyFive) {
  for (const double ratio : {27.1, 30.0, 35.0, 40.0, 45.0}) {
    const Figures zero = of("slowest-first", "lagrange0", ratio);
    EXPECT_LT(std::abs(*zero.amplitude_error), 0.1) << ratio;
    for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
      for (const char* how : {"lagrange0", "lagrange1", "lagrange2", "lagrange3", "lagrange4"}) {
        const Figures f = of(schedule, how, ratio);
        const bool judged = !f.failed && f.amplitude_error && std::abs(*f.amplitude_error) < 0.1;
        EXPECT_TRUE(!judged || *zero.position_error <= *f.position_error)
            << schedule << " " << how << " at " << ratio;
      }
  }
}

TEST(TwoMassTest, FastestFirstPeaksNearFortyAndHidesADampedModeAboveFifty) {
  const auto amplitude = [](double ratio) {
    return *of("fastest-first", "lagrange3", ratio).amplitude_error;
  };
  const auto position = [](double ratio) { return *of("fastest-first", "lagrange3", ratio).position_error; };
  EXPECT_GT(position(37.5), 2.0 * position(30.0));
  EXPECT_GT(position(37.5), 1.5 * position(60.0));
  EXPECT_LT(amplitude(70.0), -0.95) << "the fast mode is gone";
  EXPECT_LT(position(70.0), 0.08) << "and the position error does not tell";
  EXPECT_GT(amplitude(90.0), 0.5) << "from about 80 it is amplified";
}

TEST(TwoMassTest, MatchedHoldKeepsTheExchangeEnergyAtEveryRatioToAHundred) {
  for (const double ratio : sweep_ratios())
    for (const char* schedule : {"slowest-first", "fastest-first", "staggered"}) {
      if (ratio > 100.0) continue;
      EXPECT_LT(*of(schedule, "matched_hold", ratio).exchange_energy_error, 2.4e-6)
          << schedule << " at " << ratio;
    }
}

TEST(TwoMassTest, LagrangeZeroDoesNotFastestFirst) {
  for (const double ratio : {20.0, 30.7, 50.0, 70.0})
    EXPECT_GT(*of("fastest-first", "lagrange0", ratio).exchange_energy_error, 0.1) << ratio;
}

}  // namespace
}  // namespace tandem::two_mass
