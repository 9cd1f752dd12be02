// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Blocks against what they say they are, in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "diagram_run.hpp"

namespace tandem::engine {
namespace {

using test::DiagramRun;

/// The signal "y" at t, by steps of 5 ms.
double at(double t, const std::string& blocks) {
  DiagramRun run("[blocks]\n" + blocks + "\n[outputs]\ny = { unit = '1' }\n");
  return run.run(t, static_cast<int>(std::lround(t / 5e-3))).output(0);
}

/// What fourth order leaves with 5 ms at rates of some 1/s.
constexpr double close = 1e-9;

TEST(Blocks, SourcesAreFunctionsOfTime) {
  EXPECT_EQ(at(1.0, "y = { kind = 'step', time = 0.5, after = 3, before = 1 }"), 3.0);
  EXPECT_EQ(at(0.4, "y = { kind = 'step', time = 0.5, after = 3, before = 1 }"), 1.0);
  EXPECT_NEAR(at(1.0, "y = { kind = 'ramp', time = 0.4, slope = 2, start = 1 }"), 2.2, 1e-15);
  EXPECT_NEAR(at(0.3, "y = { kind = 'sine', amplitude = 2, frequency = 0.5, phase = 0.1, mean = 1 }"),
              1.0 + 2.0 * std::sin(0.3 * std::numbers::pi + 0.1), 1e-15);
}

TEST(Blocks, FunctionsAndTablesAreThoseOfTheirInputs) {
  EXPECT_NEAR(at(0.7, "y = { kind = 'polynomial', input = 'time', coefficients = [1, 2, 3] }"),
              1.0 + 1.4 + 3.0 * 0.49, 1e-15);
  EXPECT_NEAR(at(0.7, "y = { kind = 'function', function = 'exp', input = 'time' }"), std::exp(0.7), 1e-15);
  EXPECT_NEAR(at(0.7, "y = { kind = 'function', function = 'atan2', inputs = ['time', 2] }"),
              std::atan2(0.7, 2.0), 1e-15);
  EXPECT_NEAR(at(0.7, "y = { kind = 'table', input = 'time', x = [0, 0.5, 1], y = [1, 2, 0] }"),
              2.0 - 0.2 * 4.0, 1e-15);
  EXPECT_EQ(at(1.7, "y = { kind = 'table', input = 'time', x = [0, 1], y = [1, 2] }"), 2.0);
  EXPECT_NEAR(at(1.7, "y = { kind = 'table', input = 'time', x = [0, 1], y = [1, 2], beyond = 'extend' }"),
              2.7, 1e-15);
}

/// A lag of 0.5 s on a constant 2 from 1: 2 - e^(-2t); the others as noted.
TEST(Blocks, LagAndTransferFunctionAreTheirStepResponses) {
  EXPECT_NEAR(at(1.0, "y = { kind = 'lag', input = 2, time = 0.5, initial = 1 }"), 2.0 - std::exp(-2.0),
              close);
  // (s + 3) / (s^2 + 3 s + 2) on 1: 3/2 - 2 e^-t + e^-2t / 2.
  EXPECT_NEAR(
      at(1.0, "y = { kind = 'transfer_function', input = 1, numerator = [2, 6], denominator = [2, 6, 4] }"),
      1.5 - 2.0 * std::exp(-1.0) + 0.5 * std::exp(-2.0), close);
  // (s + 2) / (s + 1) on 1: 2 - e^-t.
  EXPECT_NEAR(
      at(1.0, "y = { kind = 'transfer_function', input = 1, numerator = [1, 2], denominator = [1, 1] }"),
      2.0 - std::exp(-1.0), close);
}

/// The same (s + 3) / (s^2 + 3 s + 2), with the input besides.
TEST(Blocks, StateSpaceIsItsMatrices) {
  EXPECT_NEAR(
      at(1.0,
         "y = { kind = 'state_space', inputs = [1], a = [0, 1, -2, -3], b = [0, 1], c = [3, 1], d = [5] }"),
      1.5 - 2.0 * std::exp(-1.0) + 0.5 * std::exp(-2.0) + 5.0, close);
}

/// Up with 2 to the limit 1 at 0.5 s; from 1 s on down with -1: 1 - 0.3 at 1.3 s.
TEST(Blocks, AnIntegratorLeavesItsLimitWhereItsInputPointsInwards) {
  const std::string blocks =
      "u = { kind = 'step', time = 1, before = 2, after = -1 }\ny = { kind = 'integrator', input = 'u', low "
      "= -1, high = 1 }";
  EXPECT_NEAR(at(0.4, blocks), 0.8, 1e-12);
  EXPECT_EQ(at(0.8, blocks), 1.0);
  EXPECT_NEAR(at(1.3, blocks), 0.7, 1e-9);
  EXPECT_EQ(at(4.0, blocks), -1.0);
}

/// P and I on a constant; with the limit the integral grows no further than back-calculation lets it:
/// I' = ki e + back (high - kp e - I), so I comes to high - kp e + ki e / back.
TEST(Blocks, PidWindsNoFurtherThanItsLimit) {
  EXPECT_NEAR(at(1.0, "y = { kind = 'pid', input = 2, kp = 3, ki = 0.5 }"), 6.0 + 1.0, 1e-12);
  const std::string blocks =
      "e = { kind = 'step', time = 20, before = 2, after = -1 }\ny = { kind = 'pid', input = 'e', kp = 1, ki "
      "= 1, back = 2, high = 5, low = -5 }";
  EXPECT_EQ(at(10.0, blocks), 5.0);
  EXPECT_NEAR(at(20.5, blocks), -1.0 + (5.0 - 2.0 + 1.0) - 0.5, 1e-6);
}

/// kd s / (1 + s / filter) on t: kd (1 - e^(-filter t)).
TEST(Blocks, PidDifferentiatesThroughItsFilter) {
  EXPECT_NEAR(at(1.0, "y = { kind = 'pid', input = 'time', kp = 0, kd = 2, filter = 3 }"),
              2.0 * (1.0 - std::exp(-3.0)), 1e-8);
}

TEST(Blocks, SamplesAndDelaysHoldBetweenTheirTimes) {
  EXPECT_NEAR(at(1.07, "y = { kind = 'sample', input = 'time', period = 0.1 }"), 1.0, 1e-12);
  EXPECT_NEAR(at(1.07, "y = { kind = 'unit_delay', input = 'time', period = 0.1, initial = 9 }"), 0.9, 1e-12);
  EXPECT_EQ(at(0.07, "y = { kind = 'unit_delay', input = 'time', period = 0.1, initial = 9 }"), 9.0);
}

/// On 2 t with a rate of at most 1: y' = 2 (1 - e^(-t / T)) up to 1 at t = T ln 2, then y' = 1; down with -3.
TEST(Blocks, ARateLimiterFollowsWithinItsRates) {
  const std::string up =
      "u = { kind = 'ramp', slope = 2 }\n"
      "y = { kind = 'rate_limiter', input = 'u', rising = 1, falling = 3, time = 0.1 }";
  EXPECT_NEAR(at(1.0, up), 1.0 - 0.1 * (1.0 - std::log(2.0)), 1e-8);
  const std::string limited = "y = { kind = 'rate_limiter', rising = 1, falling = 3, time = 0.1, ";
  EXPECT_NEAR(at(0.5, limited + "input = -9, initial = 1 }"), -0.5, 1e-12);
  EXPECT_EQ(at(0.5, limited + "input = 7 }"), 7.0);
}

/// At t it shows what was there one own step before, 5 ms.
TEST(Blocks, AMemoryIsOneOwnStepBehind) {
  EXPECT_NEAR(at(1.0, "y = { kind = 'memory', input = 'time', initial = 9 }"), 1.0 - 5e-3, 1e-15);
  EXPECT_EQ(at(0.005, "y = { kind = 'memory', input = 'time', initial = 9 }"), 0.0);
  EXPECT_EQ(at(0.01,
               "g = { kind = 'gain', input = 'y', gain = 2, offset = 1 }\n"
               "y = { kind = 'memory', input = 'g', initial = 3 }"),
            15.0);
}

/// On above 0.5, off below -0.5: sin t is above 0.5 from 0.52, below -0.5 from 3.67.
TEST(Blocks, ARelayRemembers) {
  const std::string blocks =
      "s = { kind = 'function', function = 'sin', input = 'time' }\ny = { kind = 'relay', input = 's', low "
      "= "
      "-0.5, high = 0.5, on = 4 }";
  EXPECT_EQ(at(0.5, blocks), 0.0);
  EXPECT_EQ(at(0.6, blocks), 4.0);
  EXPECT_EQ(at(3.5, blocks), 4.0);
  EXPECT_EQ(at(3.7, blocks), 0.0);
}

}  // namespace
}  // namespace tandem::engine
