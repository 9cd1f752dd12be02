// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The order of a fixed step with delays, against exact solutions.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "diagram_run.hpp"
#include "refusal.hpp"

namespace tandem::engine {
namespace {

using test::DiagramRun;

double error(const std::string& text, double t, double exact, int steps) {
  DiagramRun run(text);
  return std::abs(run.run(t, steps).output(0) - exact);
}

/// The observed order between so many steps and twice as many.
double delay_order(const std::string& text, double t, double exact, int steps) {
  return std::log2(error(text, t, exact, steps) / error(text, t, exact, 2 * steps));
}

const std::string output = "[outputs]\nx = { unit = '1' }\n";

/// Exact: 0 until t = 0.4, then (1 - cos w (t - 0.4)) / w. The kink of the delayed sine is a point of it.
TEST(DelayOrder, IsFourOfASmoothSignal) {
  const std::string text =
      "[blocks]\nu = { kind = 'sine', amplitude = 1, frequency = 1 }\nd = { kind = 'delay', input = 'u', "
      "delay "
      "= 0.4 }\nx = { kind = 'integrator', input = 'd' }\n" +
      output;
  const double w = 2.0 * std::numbers::pi;
  EXPECT_NEAR(delay_order(text, 2.3, (1.0 - std::cos(w * 1.9)) / w, 60), 4.0, 0.2);
}

/// x' = -3 x(t - 1), x = 1 up to t = 0, by the method of steps: x = sum over k of (-3)^k (t - k + 1)^k / k!
/// as far as t - k + 1 > 0. Its derivatives jump at 0, 1, 2, .., which is no multiple of the steps.
TEST(DelayOrder, IsFourOfADelayedFeedback) {
  const std::string text =
      "[blocks]\nd = { kind = 'delay', input = 'x', delay = 1, initial = 1 }\nr = { kind = 'gain', input = "
      "'d', "
      "gain = -3 }\nx = { kind = 'integrator', input = 'r', initial = 1 }\n" +
      output;
  const double t = 8.7;
  double exact = 0.0, factorial = 1.0;
  for (int k = 0; t - k + 1 > 0.0; factorial *= ++k) exact += std::pow(-3.0 * (t - k + 1), k) / factorial;
  EXPECT_NEAR(delay_order(text, t, exact, 61), 4.0, 0.2);
}

/// A jump at 0.31 comes 0.5 later, where a step ends: straight lines are exact.
TEST(DelayOrder, JumpsComeWhereTheyShould) {
  DiagramRun run(
      "[blocks]\nu = { kind = 'step', time = 0.31, after = 2 }\nd = { kind = 'delay', input = 'u', delay = "
      "0.5 "
      "}\nx = { kind = 'integrator', input = 'd' }\n" +
      output);
  run.run(1.0, 7);
  EXPECT_NEAR(run.simulation.output(0), 2.0 * (1.0 - 0.81), 1e-12);
}

/// Two delays, one after the other.
TEST(DelayOrder, DelaysStandInARow) {
  DiagramRun run(
      "[blocks]\nu = { kind = 'ramp', time = 0.2, slope = 3 }\nd = { kind = 'delay', input = 'u', delay = "
      "0.25 "
      "}\nx = { kind = 'delay', input = 'd', delay = 0.3 }\n" +
      output);
  run.run(1.0, 9);
  EXPECT_NEAR(run.simulation.output(0), 3.0 * 0.25, 1e-12);
}

/// A step longer than the delay is taken in parts.
TEST(DelayOrder, StepsMayBeLongerThanTheDelay) {
  DiagramRun run(
      "[blocks]\nd = { kind = 'delay', input = 'time', delay = 0.03, initial = -0.03 }\nx = { kind = "
      "'integrator', input = 'd', initial = 0 }\n" +
      output);
  run.run(1.0, 4);
  EXPECT_NEAR(run.simulation.output(0), -0.03 * 0.03 + 0.5 * 0.97 * 0.97, 1e-12);
}

TEST(DelayOrder, ThePastIsPartOfTheState) {
  DiagramRun run(
      "[blocks]\nd = { kind = 'delay', input = 'x', delay = 0.2, initial = 1, points = 30 }\nr = { kind = "
      "'gain', "
      "input = 'd', gain = -3 }\nx = { kind = 'integrator', input = 'r', initial = 1 }\n" +
      output);
  run.run(1.0, 100);
  const auto kept = run.simulation.keep();
  const auto go_on = [&] {
    for (int k = 1; k <= 50; ++k) run.simulation.run(1.0 + 0.01 * k);
    return run.simulation.output(0);
  };
  const double first = go_on();
  run.simulation.restore(1.0, kept);
  EXPECT_EQ(go_on(), first);
}

TEST(DelayOrder, TooFewPointsAreAnErrorWithTheBlocksName) {
  DiagramRun run("[blocks]\nx = { kind = 'delay', input = 'time', delay = 0.5, points = 20 }\n" + output);
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, {"'x'", "20 points", "0.5 s", "points"},
                            [&] { run.run(1.0, 100); }));
}

}  // namespace
}  // namespace tandem::engine
