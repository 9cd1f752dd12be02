// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Algebraic loops that are solved: exact values, the order of a fixed step through them, restarts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagram_run.hpp"
#include "refusal.hpp"
#include "word.hpp"

namespace tandem::engine {
namespace {

using test::DiagramRun;
using test::refuses;

/// Tight tolerances for those that have them.
IntegratorSettings tight(const std::string& name) {
  if (name == "rk4" || name == "erkstep_fixed") return {.name = name};
  return {.name = name, .adaptive = {.relative_tolerance = 1e-9, .absolute_tolerance = 1e-11}};
}

const std::string solve = "[loops]\nsolve = true\n";

/// x = y + y^3 is solved for y, x' = -y - 3 y^3: y = e^-t, x = e^-t + e^-3t.
const std::string cubic = solve +
                          "[blocks]\ny = { kind = 'sum', inputs = ['x', 'cube'], gains = [1, -1] }\n"
                          "cube = { kind = 'product', inputs = ['y', 'y', 'y'] }\n"
                          "rate = { kind = 'sum', inputs = ['y', 'cube'], gains = [-1, -3] }\n"
                          "x = { kind = 'integrator', input = 'rate', initial = 2 }\n[outputs]\n"
                          "x = { unit = '1' }\ny = { unit = '1' }\n";

TEST(Loop, KeepsTheOrderOfAFixedStep) {
  const auto error = [](int steps) {
    DiagramRun run(cubic);
    return std::abs(run.run(2.0, steps).output(0) - std::exp(-2.0) - std::exp(-6.0));
  };
  EXPECT_NEAR(std::log2(error(20) / error(40)), 4.0, 0.2);
}

class LoopByEach : public testing::TestWithParam<std::string> {};

TEST_P(LoopByEach, IsSolvedAtEachEvaluation) {
  IntegratorSettings settings{.name = GetParam()};
  if (settings.name != "rk4" && settings.name != "erkstep_fixed")
    settings.adaptive = {.relative_tolerance = 1e-9, .absolute_tolerance = 1e-12};
  DiagramRun run(cubic, settings);
  run.run(2.0, 200);
  EXPECT_NEAR(run.simulation.output(1), std::exp(-2.0), 1e-7);
}

TEST_P(LoopByEach, GoesOnFromAStateThatWasKeptToTheLastBit) {
  DiagramRun run(cubic, {.name = GetParam()});
  run.run(1.0, 10);
  const auto kept = run.simulation.keep();
  const auto go_on = [&] {
    for (int k = 1; k <= 10; ++k) run.simulation.run(1.0 + 0.1 * k);
    return run.simulation.output(0);
  };
  const double first = go_on();
  run.simulation.restore(1.0, kept);
  EXPECT_EQ(go_on(), first);
}

/// e = u - k y, and y = e cut to low, high, or what e is beyond them: y is u/(1 + k) cut likewise, or
/// what u is beyond them, over 1 + k. What integrates y sees each of its bends.
TEST_P(LoopByEach, LeavesASaturationAndADeadZoneInIt) {
  const struct {
    double size, low, high, k;
  } loops[] = {
      {3.0, -0.5, 0.5, 2.0}, {3.0, -0.5, 0.6, 2.0}, {7.04, -0.82, 0.15, 4.61}, {1.3, -0.21, 0.93, 0.37}};
  for (const auto& [size, low, high, k] : loops)
    for (const std::string kind : {"saturation", "dead_zone"}) {
      DiagramRun run(solve + fmt::format("[blocks]\nu = {{ kind = 'sine', amplitude = {}, frequency = 1 }}\n"
                                         "e = {{ kind = 'sum', inputs = ['u', 'y'], gains = [1, {}] }}\n"
                                         "y = {{ kind = '{}', input = 'e', low = {}, high = {} }}\n"
                                         "x = {{ kind = 'integrator', input = 'y' }}\n"
                                         "[outputs]\ny = {{ unit = '1' }}\nx = {{ unit = '1' }}\n",
                                         size, -k, kind, low, high),
                     tight(GetParam()));
      const auto exact = [&](double t) {
        const double u = size * std::sin(2.0 * std::numbers::pi * t);
        return kind == "saturation" ? std::clamp(u / (1.0 + k), low, high)
                                    : (u - std::clamp(u, low, high)) / (1.0 + k);
      };
      double integral = 0.0;  // to 1e-9, by midpoints
      for (int i = 0; i < 170000; ++i) integral += 1e-5 * exact(1e-5 * (i + 0.5));
      run.run(1.7, 170);
      EXPECT_NEAR(run.simulation.output(0), exact(1.7), 1e-9) << kind << ", k = " << k;
      EXPECT_NEAR(run.simulation.output(1), integral, 1e-7) << kind << ", k = " << k;
    }
}

INSTANTIATE_TEST_SUITE_P(Integrators, LoopByEach, testing::ValuesIn(integrator_names()),
                         [](const auto& p) { return test::word(p.param); });

/// The value of y at the start.
double at_start(const std::string& text) {
  DiagramRun run(solve + text + "[outputs]\ny = { unit = '1' }\n");
  run.simulation.start(2.0);
  return run.simulation.output(0);
}

/// y = 2 + 3 - 4 y / 5, with y as each of the terms; a = 3 b + 1, b = a + a - y, y = b + 1: a cut at two.
TEST(Loop, OfStraightLinesIsExact) {
  EXPECT_NEAR(at_start("[blocks]\ny = { kind = 'sum', inputs = ['time', 3, 'y'], gains = [1, 1, -0.8] }\n"),
              5.0 / 1.8, 1e-12);
  EXPECT_NEAR(at_start("[blocks]\ny = { kind = 'sum', inputs = ['y', 'time', 3], gains = [-0.8, 1, 1] }\n"),
              5.0 / 1.8, 1e-12);
  EXPECT_NEAR(
      at_start("[blocks]\ny = { kind = 'sum', inputs = [3, 'y', 'time', 'y', 'y'], gains = [1, -0.2, 1, "
               "-0.3, -0.3] }\n"),
      5.0 / 1.8, 1e-12);
  const std::string two =
      "[blocks]\na = { kind = 'gain', input = 'b', gain = 3, offset = 1 }\n"
      "b = { kind = 'sum', inputs = ['a', 'y'], gains = [2, -1] }\ny = { kind = 'gain', input = 'b', gain = "
      "1, "
      "offset = 1 }\n";
  EXPECT_NEAR(at_start(two), 0.75, 1e-12);  // b = 6 b + 2 - b - 1
}

/// y^2 = 4, from either side.
TEST(Loop, GoesToTheSolutionNextToTheGuess) {
  const std::string blocks =
      "[blocks]\nsquare = { kind = 'product', inputs = ['y', 'y'] }\ny = { kind = 'sum', inputs = ['y', "
      "'square', "
      "4], gains = [1, -1, 1] }\n[loops.guess]\ny = ";
  EXPECT_NEAR(at_start(blocks + "1\n"), 2.0, 1e-12);
  EXPECT_NEAR(at_start(blocks + "-1\n"), -2.0, 1e-12);
}

TEST(Loop, WithoutASolutionIsASentence) {
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"blocks y, square", "t = 2 s", "residual", "1e-12"}, [] {
    at_start(
        "[blocks]\nsquare = { kind = 'product', inputs = ['y', 'y'] }\ny = { kind = 'sum', inputs = ['y', "
        "'square', 1] }\n");
  }));
}

TEST(Loop, ThatIsFedWithWhatIsNotANumberNamesWhoGivesIt) {
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"block 'b' (diagram:5) gives", "nan at t = 2 s"}, [] {
    at_start(
        "[blocks]\nlow = { kind = 'gain', input = 'time', gain = -1 }\n"
        "b = { kind = 'function', function = 'sqrt', input = 'low' }\n"
        "half = { kind = 'gain', input = 'y', gain = -0.5 }\ny = { kind = 'sum', inputs = ['b', 'half'] }\n");
  }));
}

/// y = sqrt(1 - x), up to x = 1; each integrator says so in the loop's words.
TEST_P(LoopByEach, ThatLosesItsSolutionOnTheWayIsASentence) {
  DiagramRun run(solve +
                     "[blocks]\nx = { kind = 'integrator', input = 1 }\n"
                     "y = { kind = 'sum', inputs = ['y', 'square', 'x', 1], gains = [1, 1, 1, -1] }\n"
                     "square = { kind = 'product', inputs = ['y', 'y'] }\n"
                     "z = { kind = 'integrator', input = 'y' }\n[outputs]\nz = { unit = '1' }\n",
                 {.name = GetParam()});
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"algebraic loop", "blocks square, y", "no solution", "residual"},
                      [&] { run.run(2.0, 20); }));
}

TEST(Loop, IsRefusedByPlaceWhereItsTableIsWrong) {
  const auto refused = [](const std::string& table, const std::vector<std::string>& words) {
    return refuses(ErrorCode::invalid_argument, words, [&] {
      DiagramRun("[loops]\n" + table +
                 "\n[blocks]\ny = { kind = 'constant', value = 1 }\n[outputs]\ny = { unit = '1' }\n");
    });
  };
  EXPECT_TRUE(refused("solve = 1", {"diagram:2", "loops.solve", "true or false"}));
  EXPECT_TRUE(refused("tolerance = 0", {"diagram:2", "loops.tolerance", "above 0"}));
  EXPECT_TRUE(refused("guess = { z = 1 }", {"diagram:1", "signal 'z' is not there"}));
  EXPECT_TRUE(refused("method = 'newton'", {"diagram:2", "'method'"}));
}

}  // namespace
}  // namespace tandem::engine
