// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Blocks that decide, where a run begins beyond or at what they decide by.
#include <gtest/gtest.h>

#include <string>

#include "diagram_run.hpp"
#include "refusal.hpp"

namespace tandem::engine {
namespace {

double end(const std::string& blocks, double t = 1.0) {
  return test::DiagramRun("[outputs]\ny = { unit = '1' }\n[blocks]\n" + blocks).run(t, 10).output(0);
}

TEST(Start, OfAnIntegratorAtItsLimitIsHeldUntilItsInputPointsInwards) {
  EXPECT_EQ(end("y = { kind = 'integrator', input = -1, low = 0, initial = 0 }\n"), 0.0);
  EXPECT_EQ(end("y = { kind = 'integrator', input = 1, high = 0, initial = 0 }\n"), 0.0);
  EXPECT_NEAR(end("y = { kind = 'integrator', input = 1, low = 0, initial = 0 }\n"), 1.0, 1e-12);
  const std::string turns = "u = { kind = 'gain', input = 'time', gain = 1, offset = -0.5 }\n";
  EXPECT_NEAR(end(turns + "y = { kind = 'integrator', input = 'u', low = 0, initial = 0 }\n"), 0.125, 1e-12);
  const std::string falls = "u = { kind = 'gain', input = 'time', gain = -1 }\n";
  EXPECT_NEAR(end(falls + "y = { kind = 'integrator', input = 'u', high = 2, initial = 2 }\n"), 1.5, 1e-12);
}

TEST(Start, OfAnIntegratorIsWithinItsLimits) {
  const std::string from = "u = { kind = 'gain', input = 'time', gain = 0, offset = 5 }\n";
  EXPECT_EQ(end(from + "y = { kind = 'integrator', input = 1, high = 2, initial = 'u' }\n"), 2.0);
  EXPECT_NEAR(end(from + "y = { kind = 'integrator', input = -1, high = 2, initial = 'u' }\n"), 1.0, 1e-12);
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"diagram:4", "initial", "is 3", "0 to 2"}, [] {
    end("y = { kind = 'integrator', input = 1, low = 0, high = 2, initial = 3 }\n");
  }));
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"reset_to", "is -1", "0 to 2"}, [] {
    end("y = { kind = 'integrator', input = 1, low = 0, high = 2, reset = 'time', reset_to = -1 }\n");
  }));
}

/// Held at 0 by a reset to the limit, whichever way the input points then.
TEST(Start, AfterAResetToALimitIsAsAtTheStart) {
  const std::string reset = "at = { kind = 'gain', input = 'time', gain = 1, offset = -0.5 }\n";
  EXPECT_EQ(end(reset + "y = { kind = 'integrator', input = -1, low = 0, initial = 2, reset = 'at' }\n"),
            0.0);
  EXPECT_NEAR(end(reset + "y = { kind = 'integrator', input = 1, low = 0, initial = 2, reset = 'at' }\n"),
              0.5, 1e-12);
}

TEST(Start, OfARelayIsWhereItsInputIs) {
  const auto relay = [](double input, const char* more) {
    return end("y = { kind = 'relay', input = " + std::to_string(input) + ", low = 1, high = 2" + more +
               " }\n");
  };
  EXPECT_EQ(relay(3.0, ""), 1.0);
  EXPECT_EQ(relay(1.5, ""), 0.0);
  EXPECT_EQ(relay(1.5, ", starts_on = true"), 1.0);
  EXPECT_EQ(relay(0.5, ", starts_on = true"), 0.0);
}

/// Angles passed, counted: from 5.5 on 6, 7, 8, .. ; and those that a jump of 2.5 passes count as one.
TEST(Start, OfWhatPassesIsBehindWhatHasBeenPassed) {
  const std::string count =
      "p = { kind = 'passes', input = 'u', every = 1 }\n"
      "y = { kind = 'sample', trigger = 'p', input = 'next' }\n"
      "next = { kind = 'gain', input = 'y', gain = 1, offset = 1 }\n";
  EXPECT_EQ(end("u = { kind = 'gain', input = 'time', gain = 10, offset = 5.55 }\n" + count), 10.0);
  EXPECT_EQ(end("u = { kind = 'sum', inputs = ['s', 'time'] }\n"
                "s = { kind = 'step', time = 0.45, after = 2.6 }\n" +
                    count,
                2.0),
            2.0);
  // 4, then 5 at the instant of the jump to 8.3, one event; then 9 to 13
  EXPECT_EQ(end("u = { kind = 'sum', inputs = ['s', 'r'] }\nr = { kind = 'ramp', slope = 10 }\n"
                "s = { kind = 'step', time = 0.5, after = 3.3 }\n" +
                    count,
                1.0),
            10.0);
}

}  // namespace
}  // namespace tandem::engine
