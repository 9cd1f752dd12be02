// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Where a diagram returns because an output jumps, and what has no end.
#include <gtest/gtest.h>

#include <cmath>

#include "diagram_run.hpp"
#include "refusal.hpp"

namespace tandem::engine {
namespace {

using test::DiagramRun;

/// A step at 0.35 s, a saturation that it reaches at once and leaves late, and a ramp that is reset.
const char* const jumping =
    "[blocks]\ns = { kind = 'step', time = 0.35, after = 2 }\nl = { kind = 'lag', input = 's', time = 0.5 }\n"
    "c = { kind = 'saturation', input = 'l', low = -1, high = 1 }\none = { kind = 'constant', value = 1 }\n"
    "over = { kind = 'gain', input = 'r', gain = 1, offset = -0.8 }\n"
    "r = { kind = 'integrator', input = 'one', reset = 'over' }\n[outputs]\ns = { unit = '1' }\n"
    "c = { unit = '1' }\nr = { unit = '1' }\n";

TEST(OutputJumps, OfOutputsEndARunThereAndWhatBendsDoesNot) {
  DiagramRun d(jumping);
  Simulation& s = d.simulation;
  s.start(0.0);
  EXPECT_FALSE(s.run_to_jump(0.3));
  ASSERT_TRUE(s.run_to_jump(0.6));
  EXPECT_NEAR(s.time(), 0.35, 1e-12);
  EXPECT_EQ(s.left()[0], 0.0);
  EXPECT_EQ(s.output(0), 2.0);
  EXPECT_EQ(s.left()[2], s.output(2));  // to the bit
  EXPECT_FALSE(s.run_to_jump(0.6));
  EXPECT_EQ(s.time(), 0.6);
  EXPECT_FALSE(s.run_to_jump(0.75));  // the saturation: 0.35 + 0.5 ln 2 = 0.697
  EXPECT_EQ(s.output(1), 1.0);
  ASSERT_TRUE(s.run_to_jump(0.9));
  EXPECT_NEAR(s.time(), 0.8, 1e-12);
  EXPECT_NEAR(s.left()[2], 0.8, 1e-12);
  EXPECT_EQ(s.output(2), 0.0);
}

/// The same as one run that never returns.
TEST(OutputJumps, ChangeNothingOfARun) {
  DiagramRun whole(jumping), parts(jumping);
  whole.simulation.start(0.0), parts.simulation.start(0.0);
  for (int k = 1; k <= 30; ++k) {
    whole.simulation.run(0.1 * k);
    while (parts.simulation.run_to_jump(0.1 * k)) {
    }
    for (int output = 0; output < 3; ++output)
      EXPECT_NEAR(whole.simulation.output(output), parts.simulation.output(output), 1e-14);
  }
}

std::string ball(double e) {
  return "[blocks]\nv = { kind = 'integrator', input = -9.81, initial = 1, reset = 'below', reset_to = 'up' "
         "}\n"
         "up = { kind = 'gain', input = 'v', gain = " +
         std::to_string(-e) +
         " }\nx = { kind = 'integrator', input = 'v', initial = 0.1 }\n"
         "below = { kind = 'gain', input = 'x', gain = -1 }\n[outputs]\nx = { unit = 'm' }\n";
}

/// The last of its bounces is at t_1 + 2 v_1 e / (g (1 - e)), t_1 and v_1 those of the first.
TEST(OutputJumps, OfABallComeToAnEndThatIsTold) {
  for (const double e : {0.9, 0.8, 0.5, 0.1, 1e-3}) {
    const double v = std::sqrt(1.0 + 2 * 9.81 * 0.1), end = (1.0 + v) / 9.81 + 2 * v * e / (9.81 * (1 - e));
    for (const double h : {0.1, 0.01, 0.001}) {
      DiagramRun d(ball(e));
      d.simulation.start(0.0);
      std::string said;
      try {
        for (int k = 1; k * h < 10.0; ++k)
          while (d.simulation.run_to_jump(k * h)) {
          }
      } catch (const Error& error) {
        said = error.what();
      }
      EXPECT_NE(said.find("block 'v'"), std::string::npos) << e << " " << h << " " << said;
      EXPECT_NE(said.find("has come ever faster"), std::string::npos) << said;
      EXPECT_NEAR(d.simulation.time(), end, 1e-4) << e << " " << h;
    }
  }
}

/// Instants are counted from the start of the run; a source by time is where it is.
TEST(OutputJumps, OfSamplesAreCountedFromTheStart) {
  DiagramRun d(
      "[blocks]\nt = { kind = 'gain', input = 'time', gain = 1 }\n"
      "y = { kind = 'sample', input = 't', period = 0.25, offset = 0.1 }\n"
      "s = { kind = 'step', time = 5.3, after = 1 }\n[outputs]\ny = { unit = 's' }\ns = { unit = '1' }\n");
  Simulation& s = d.simulation;
  s.start(5.01);
  std::vector<double> times;
  for (int k = 1; k <= 10; ++k)
    while (s.run_to_jump(5.01 + 0.1 * k)) times.push_back(s.time());
  ASSERT_EQ(times.size(), 5U);
  for (const auto& [k, t] : {std::pair(0, 5.11), {1, 5.3}, {2, 5.36}, {3, 5.61}, {4, 5.86}})
    EXPECT_NEAR(times[static_cast<std::size_t>(k)], t, 1e-12);
}

}  // namespace
}  // namespace tandem::engine
