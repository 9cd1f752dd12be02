// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// One suite for every integrator of diagrams: accuracy on problems with exact solutions, events, stop times,
// restarts.
#include <gtest/gtest.h>

#include <cmath>

#include "diagram_run.hpp"
#include "refusal.hpp"
#include "word.hpp"

namespace tandem::engine {
namespace {

using test::DiagramRun;

/// Tight tolerances for those that have them; the fixed step gets there by its steps.
IntegratorSettings tight(const std::string& name) {
  IntegratorSettings settings{.name = name};
  if (name != "rk4" && name != "erkstep_fixed")
    settings.adaptive = {.relative_tolerance = 1e-10, .absolute_tolerance = 1e-12};
  return settings;
}

/// What tolerances of 1e-10 leave after some hundred steps; the fixed steps are chosen so that they leave
/// less.
constexpr double close = 3e-8;

class EachIntegrator : public testing::TestWithParam<std::string> {};

TEST_P(EachIntegrator, FollowsAnOscillator) {
  DiagramRun run(
      "[blocks]\nx = { kind = 'integrator', input = 'v', initial = 1 }\nv = { kind = 'integrator', input = "
      "'a' }\n"
      "a = { kind = 'gain', input = 'x', gain = -1 }\n[outputs]\nx = { unit = 'm' }\nv = { unit = 'm/s' }\n",
      tight(GetParam()));
  run.run(10.0, 1000);
  EXPECT_NEAR(run.simulation.output(0), std::cos(10.0), close);
  EXPECT_NEAR(run.simulation.output(1), -std::sin(10.0), close);
  EXPECT_EQ(run.simulation.time(), 10.0);
}

/// x' = -1000 (x - cos t) - sin t from x = 1: x = cos t.
TEST_P(EachIntegrator, FollowsAStiffProblem) {
  DiagramRun run(
      "[blocks]\nwave = { kind = 'function', function = 'cos', input = 'time' }\n"
      "slope = { kind = 'function', function = 'sin', input = 'time' }\n"
      "rate = { kind = 'sum', inputs = ['x', 'wave', 'slope'], gains = [-1000, 1000, -1] }\n"
      "x = { kind = 'integrator', input = 'rate', initial = 1 }\n[outputs]\nx = { unit = '1' }\n",
      tight(GetParam()));
  run.run(2.0, 2000);
  EXPECT_NEAR(run.simulation.output(0), std::cos(2.0), close);
}

/// A ball that falls from 1 m with g = 2 and has its velocity set to 0.8 of what it was, upwards, at each
/// bounce.
TEST_P(EachIntegrator, StartsAnewAtEachEvent) {
  DiagramRun run(
      "[blocks]\nx = { kind = 'integrator', input = 'v', initial = 1 }\n"
      "v = { kind = 'integrator', input = -2, reset = 'below', reset_to = 'up' }\n"
      "below = { kind = 'gain', input = 'x', gain = -1 }\nup = { kind = 'gain', input = 'v', gain = -0.8 }\n"
      "[outputs]\nx = { unit = 'm' }\nv = { unit = 'm/s' }\n",
      tight(GetParam()));
  run.run(3.0, 100);
  EXPECT_NEAR(run.simulation.output(1), 2.0 * 0.64 - 2.0 * 0.4, close);
  EXPECT_NEAR(run.simulation.output(0), 0.4 * (2.0 * 0.64 - 0.4), close);
}

/// x' = 1 up to x = 1/2, from there x' = 2 - x.
TEST_P(EachIntegrator, SwitchesWhereTheSignChanges) {
  DiagramRun run(
      "[blocks]\nx = { kind = 'integrator', input = 'rate' }\npull = { kind = 'gain', input = 'x', gain = "
      "-1, offset = 2 }\n"
      "rate = { kind = 'switch', control = 'x', threshold = 0.5, above = 'pull', below = 1 }\n"
      "[outputs]\nx = { unit = '1' }\n",
      tight(GetParam()));
  run.run(2.2, 220);
  EXPECT_NEAR(run.simulation.output(0), 2.0 - 1.5 * std::exp(-1.7), close);
}

/// A signal that is zero where an own step ends, and gets its sign in the next one: 1 up to 0.5 s, then 3;
/// and a state that comes to a limit there.
TEST_P(EachIntegrator, SeesEventsAtTheEndOfAStep) {
  DiagramRun run(
      "[blocks]\nrate = { kind = 'step', time = 0.5, before = 1, after = 3 }\n"
      "x = { kind = 'integrator', input = 'rate' }\ny = { kind = 'integrator', input = 'bent' }\n"
      "bent = { kind = 'saturation', input = 'x', low = -1, high = 0.5 }\n[outputs]\nx = { unit = '1' }\ny = "
      "{ unit "
      "= '1' }\n",
      tight(GetParam()));
  run.run(1.0, 10);
  EXPECT_NEAR(run.simulation.output(0), 0.5 + 1.5, close);
  EXPECT_NEAR(run.simulation.output(1), 0.125 + 0.25, close);
}

/// A diagram without states, too.
TEST_P(EachIntegrator, TakesSamplesAtTheirTimes) {
  DiagramRun run(
      "[blocks]\nseen = { kind = 'sample', input = 'time', period = 0.25, offset = 0.1 }\n[outputs]\nseen = "
      "{ unit = 's' }\n",
      tight(GetParam()));
  run.run(1.0, 3);
  EXPECT_EQ(run.simulation.output(0), 0.1 + 3.0 * 0.25);
}

/// To the last bit.
TEST_P(EachIntegrator, GoesOnFromAStateThatWasKept) {
  DiagramRun run(
      "[blocks]\nx = { kind = 'integrator', input = 'y', initial = 1 }\ny = { kind = 'integrator', input = "
      "'a' }\n"
      "s = { kind = 'saturation', input = 'x', low = -0.3, high = 0.3 }\na = { kind = 'gain', input = 's', "
      "gain = -9 }\n"
      "[outputs]\nx = { unit = '1' }\n",
      tight(GetParam()));
  run.run(1.0, 100);
  const auto kept = run.simulation.keep();
  const auto go_on = [&] {
    run.simulation.restore(1.0, kept);
    for (int k = 1; k <= 50; ++k) run.simulation.step(1.0 + 0.01 * k);
    return run.simulation.output(0);
  };
  const double first = go_on();
  EXPECT_EQ(go_on(), first);
}

TEST_P(EachIntegrator, TellsWhatIsNotFinite) {
  DiagramRun run(
      "[blocks]\nx = { kind = 'integrator', input = 'rate', initial = 1 }\nrate = { kind = 'product', inputs "
      "= ['x', 'x'] }\n"
      "[outputs]\nx = { unit = '1' }\n",
      tight(GetParam()));
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, {"t = "}, [&] { run.run(1.5, 15); }));
}

/// By the block that made it, if it is still there to see.
TEST_P(EachIntegrator, TellsWhichBlockGivesWhatIsNotFinite) {
  DiagramRun run(
      "[blocks]\nroot = { kind = 'function', function = 'sqrt', input = 'left' }\n"
      "left = { kind = 'gain', input = 'time', gain = -1, offset = 0.5 }\n[outputs]\nroot = { unit = '1' }\n",
      tight(GetParam()));
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, {"block 'root' (diagram:2) gives", "nan at t = 0.6"},
                            [&] { run.run(1.0, 10); }));
}

TEST_P(EachIntegrator, EndsChatteringWithASentence) {
  DiagramRun run(
      "[blocks]\nx = { kind = 'integrator', input = 'rate', initial = 0.01 }\n"
      "rate = { kind = 'switch', control = 'x', above = -1, below = 1 }\n[outputs]\nx = { unit = '1' }\n",
      tight(GetParam()));
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, {"block 'rate' (diagram:3) chatters", "1000"},
                            [&] { run.run(1.0, 1); }));
}

/// Beside an oscillation of 1 m one of 1 nm and ten times as fast, which an absolute tolerance of 1 nm does
/// not see.
class AdaptiveIntegrator : public testing::TestWithParam<std::string> {
 protected:
  static double error(const std::map<std::string, double>& absolute) {
    DiagramRun run(
        "[blocks]\nx = { kind = 'integrator', input = 'v', initial = 1 }\n"
        "v = { kind = 'integrator', input = 'a' }\na = { kind = 'gain', input = 'x', gain = -1 }\n"
        "y = { kind = 'integrator', input = 'w', initial = 1e-9 }\n"
        "w = { kind = 'integrator', input = 'b' }\nb = { kind = 'gain', input = 'y', gain = -100 }\n"
        "[outputs]\nx = { unit = 'm' }\ny = { unit = 'm' }\n",
        {.name = GetParam(), .adaptive = {.absolute_tolerances = absolute}});
    run.run(2.0, 1);
    return std::abs(run.simulation.output(1) - 1e-9 * std::cos(20.0));
  }
};

TEST_P(AdaptiveIntegrator, TakesAnAbsoluteToleranceForEachState) {
  const double tight = error({{"y", 1e-17}, {"w", 1e-16}});
  EXPECT_LT(tight, 2e-13);
  EXPECT_GT(error({}), 10.0 * tight);
}

TEST_P(AdaptiveIntegrator, RefusesTheToleranceOfAStateThatIsNotThere) {
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument,
                            {GetParam(), "absolute_tolerance.z", "state 'z' is not there", "x, v, y, w"}, [] {
                              error({{"z", 1e-9}});
                            }));
}

INSTANTIATE_TEST_SUITE_P(Integrators, AdaptiveIntegrator,
                         testing::Values("cvode_adams", "cvode_bdf", "erkstep", "arkstep"),
                         [](const auto& p) { return test::word(p.param); });

INSTANTIATE_TEST_SUITE_P(Integrators, EachIntegrator, testing::ValuesIn(integrator_names()),
                         [](const auto& p) { return test::word(p.param); });

TEST(IntegratorSettings, AreRefusedByName) {
  const auto made = [](IntegratorSettings settings) { return [settings] { make_integrator(settings); }; };
  const auto code = ErrorCode::invalid_argument;
  EXPECT_TRUE(test::refuses(code, {"'cvode'", "cvode_adams"}, made({.name = "cvode"})));
  EXPECT_TRUE(test::refuses(code, {"rk4 is chosen"}, made({.adaptive = {.relative_tolerance = 1e-3}})));
  EXPECT_TRUE(
      test::refuses(code, {"locate_events", "erkstep"}, made({.name = "erkstep", .locate_events = false})));
  EXPECT_TRUE(test::refuses(code, {"erkstep", "absolute_tolerance.x is 0"},
                            made({.name = "erkstep", .adaptive = {.absolute_tolerances = {{"x", 0.0}}}})));
  EXPECT_TRUE(test::refuses(code, {"erkstep", "relative_tolerance is -1"},
                            made({.name = "erkstep", .adaptive = {.relative_tolerance = -1}})));
}

}  // namespace
}  // namespace tandem::engine
