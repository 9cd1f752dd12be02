// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Angles in space are those of edges that tilt and stretch too.
#include <gtest/gtest.h>

#include <cmath>

#include "refusal.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

/// Points P and Q on their own, vectors that are fixed.
const std::string two_points =
    "dimension = 3\n[points]\nO = { at = [0, 0, 0], fixed = true }\nP = { at = [1, 0.5, 0.3] }\n"
    "Q = { at = [1, 0, 0.4] }\n[vectors]\nx = { at = [2, 0, 0], fixed = true }\n"
    "z = { at = [0, 0, 3], fixed = true }\n[masses]\np = { point = 'P', mass = 1, free = true }\n"
    "q = { point = 'Q', mass = 1, free = true }\n";

State state_of(const std::string& more) {
  Mechanism m(read_mechanism("m", two_points + more));
  return initial_state(m, 0.0);
}

/// About z, from Q to P seen from above: both rise beside the drawing, and P's distance from z grows.
TEST(Angles, AboutAnAxisIsThatOfTheProjections) {
  const State s = state_of(
      "[angles]\nt = { from = ['O', 'Q'], to = ['O', 'P'], axis = 'z' }\n[initial]\n"
      "positions = { 'P.x' = 1.3, 'P.y' = 0.5, 'P.z' = 1.3, 'Q.x' = 1, 'Q.y' = 0, 'Q.z' = 0.9 }\n"
      "velocities = { 'P.x' = 0, 'P.y' = 0, 'P.z' = 2, 'Q.x' = 0, 'Q.y' = 3, 'Q.z' = 4 }\n");
  EXPECT_NEAR(s.q[6], std::atan2(0.5, 1.3), 1e-9);  // the assembly's limit
  EXPECT_NEAR(s.v[6], -3.0, 1e-8);
}

TEST(Angles, FixedHoldsWhatEverTheLengths) {
  const State s = state_of(
      "[fixed_angles]\nf = { edges = ['x', ['O', 'Q']] }\n"
      "[initial]\npositions = { 'P.x' = 1, 'P.y' = 0.5, 'P.z' = 0.3, 'Q.x' = 5, 'Q.y' = 0 }\n"
      "velocities = { 'Q.x' = 1, 'Q.y' = 0 }\n");
  EXPECT_NEAR(s.q[5], 2.0, 1e-8);  // 5 times as drawn
  EXPECT_NEAR(s.v[5], 0.4, 1e-8);
}

TEST(Angles, TurnAboutVectorsAlone) {
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument,
                            {"m:13: angles.t.axis is the point 'Q'; allowed is the name of a vector"},
                            [] { state_of("[angles]\nt = { from = 'x', to = ['O', 'P'], axis = 'Q' }\n"); }));
}

}  // namespace
}  // namespace tandem::mbs
