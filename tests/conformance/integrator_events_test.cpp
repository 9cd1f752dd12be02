// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// One suite for every integrator of diagrams, where events are awkward: diagrams without states, signals that
// stay zero, limits with resets, several events at one instant; and a run that goes on from a kept state
// against one that was not interrupted.
#include <gtest/gtest.h>

#include <cmath>

#include "diagram_run.hpp"
#include "refusal.hpp"
#include "word.hpp"

namespace tandem::engine {
namespace {

using test::DiagramRun;

class EventsByEach : public testing::TestWithParam<std::string> {
 protected:
  IntegratorSettings settings() const { return {.name = GetParam()}; }
};

/// A relay on a ramp, in one step across its threshold; what it gives then is sampled.
TEST_P(EventsByEach, AreLocatedWithoutStates) {
  DiagramRun run(
      "[blocks]\non = { kind = 'relay', input = 'time', low = 0.2, high = 0.5 }\n"
      "since = { kind = 'sample', trigger = 'edge', input = 'time', initial = -1 }\n"
      "edge = { kind = 'gain', input = 'on', gain = 1, offset = -0.5 }\n"
      "[outputs]\nsince = { unit = 's' }\non = { unit = '1' }\n",
      settings());
  run.run(0.9, 3);
  EXPECT_NEAR(run.simulation.output(0), 0.5, 1e-12);
  EXPECT_EQ(run.simulation.output(1), 1.0);
}

/// A wave integrated between limits stands at them for half of each period, where its signals are zero.
TEST_P(EventsByEach, OfASignalThatStaysZeroAreSeenWhereItLeaves) {
  for (const int steps : {667, 2857}) {
    DiagramRun run(
        "[blocks]\nw = { kind = 'sine', frequency = 1, amplitude = 1 }\n"
        "x = { kind = 'integrator', input = 'w', low = -0.1, high = 0.1 }\n"
        "r = { kind = 'relay', input = 'w', low = -0.5, high = 0.5 }\n"
        "[outputs]\nx = { unit = '1' }\nr = { unit = '1' }\n",
        settings());
    run.run(20.0, steps);
    // From the trough at t = 19.5 + to the limit: -0.1 + (1 - cos 2 pi t)/2 pi.
    EXPECT_NEAR(run.simulation.output(0), -0.1, 1e-4) << steps;
    EXPECT_EQ(run.simulation.output(1), 0.0) << steps;
  }
}

/// 0.3 at 0.3 s; back to 0.1 at 0.5 s and at 0.3 again at 0.7 s.
TEST_P(EventsByEach, OfAResetFreeWhatALimitHeld) {
  DiagramRun run(
      "[blocks]\nat = { kind = 'step', time = 0.5, after = 1 }\nback = { kind = 'gain', input = 'at', gain = "
      "1, offset "
      "= "
      "-0.5 }\n"
      "y = { kind = 'integrator', input = 1, high = 0.3, reset = 'back', reset_to = 0.1 }\n"
      "[outputs]\ny = { unit = '1' }\n",
      settings());
  EXPECT_NEAR(run.run(0.4, 40).output(0), 0.3, 1e-9);
  EXPECT_NEAR(run.run(0.6, 60).output(0), 0.2, 1e-9);
  EXPECT_NEAR(run.run(1.0, 100).output(0), 0.3, 1e-9);
}

/// At 0.5 s two relays switch, and a third that the sum of both drives.
TEST_P(EventsByEach, AtOneInstantAllHappen) {
  DiagramRun run(
      "[blocks]\nx = { kind = 'integrator', input = 1 }\n"
      "a = { kind = 'relay', input = 'x', low = 0, high = 0.5 }\n"
      "b = { kind = 'relay', input = 'double', low = 0, high = 1 }\n"
      "double = { kind = 'gain', input = 'x', gain = 2 }\nboth = { kind = 'sum', inputs = ['a', 'b'] }\n"
      "c = { kind = 'relay', input = 'both', low = 0.5, high = 1.5 }\n"
      "y = { kind = 'integrator', input = 'c' }\n[outputs]\ny = { unit = '1' }\n",
      settings());
  EXPECT_NEAR(run.run(1.0, 3).output(0), 0.5, 1e-9);
}

/// To the last bit, as keep() lets the integrator begin anew in both.
TEST_P(EventsByEach, GoOnFromAStateAsWithoutABreak) {
  const std::string text =
      "[blocks]\nx = { kind = 'integrator', input = 'v', initial = 1, low = -0.5 }\n"
      "v = { kind = 'integrator', input = 'a' }\na = { kind = 'gain', input = 'x', gain = -9 }\n"
      "[outputs]\nx = { unit = '1' }\n";
  DiagramRun whole(text, settings()), second(text, settings());
  whole.run(1.0, 100);
  const std::vector<double> kept = whole.simulation.keep();
  second.simulation.start(0.0);
  second.simulation.restore(1.0, kept);
  for (int k = 1; k <= 100; ++k) {
    whole.simulation.run(1.0 + 0.01 * k);
    second.simulation.run(1.0 + 0.01 * k);
    ASSERT_EQ(second.simulation.output(0), whole.simulation.output(0)) << k;
  }
}

/// What only decides, and never reaches an output itself.
TEST_P(EventsByEach, DoNotFollowFromWhatIsNotANumber) {
  const std::string root =
      "[blocks]\nroot = { kind = 'function', function = 'sqrt', input = 'left' }\n"
      "left = { kind = 'gain', input = 'time', gain = -1, offset = 0.505 }\n[outputs]\ny = { unit = '1' }\n"
      "[blocks.y]\n";
  for (const std::string y : {"kind = 'switch'\ncontrol = 'root'\nabove = 1\nbelow = 2\n",
                              "kind = 'saturation'\ninput = 'root'\nlow = 0\nhigh = 1\n",
                              "kind = 'dead_zone'\ninput = 'root'\nlow = -1\nhigh = 1\n",
                              "kind = 'relay'\ninput = 'root'\nlow = 0\nhigh = 1\n",
                              "kind = 'integrator'\ninput = 1\nreset = 'root'\n",
                              "kind = 'rate_limiter'\ninput = 'root'\ntime = 1\nrising = 1\nfalling = 1\n",
                              "kind = 'function'\nfunction = 'max'\ninputs = [0, 'root']\n",
                              "kind = 'function'\nfunction = 'sign'\ninput = 'root'\n",
                              "kind = 'table'\ninput = 'root'\nx = [0, 1]\ny = [3, 4]\nbeyond = 'hold'\n"}) {
    DiagramRun run(root + y, settings());
    EXPECT_TRUE(test::refuses(ErrorCode::numerical, {"block 'root' (diagram:2) gives", "nan at t = 0.5"},
                              [&] { run.run(1.0, 100); }))
        << y;
  }
}

INSTANTIATE_TEST_SUITE_P(Integrators, EventsByEach, testing::ValuesIn(integrator_names()),
                         [](const auto& p) { return test::word(p.param); });

}  // namespace
}  // namespace tandem::engine
