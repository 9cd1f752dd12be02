// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/initial.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "four_bar/linkage.hpp"
#include "refusal.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/sparse/products.hpp"

namespace tandem::mbs {
namespace {

using test::refuses;

/// A crank of 0.2 m, a rod of 0.6 m, a slider on the x axis; drawn roughly.
std::string slider_crank(const std::string& initial) {
  return "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nX = { at = [1, 0], fixed = true }\n"
         "A = { at = [0.15, 0.15] }\nB = { at = [0.7, 0.05] }\n"
         "[masses]\na = { point = 'A', mass = 1 }\nb = { point = 'B', mass = 1 }\n"
         "[distances]\ncrank = { points = ['O', 'A'], length = 0.2 }\nrod = { points = ['A', 'B'], length = "
         "0.6 }\n"
         "[joints.slide]\nkind = 'point_on_line'\nbetween = ['B', 'ground']\nat = [0.7, 0.05]\naxis = [1, "
         "0]\n"
         "[angles]\ntheta = { from = ['O', 'X'], to = ['O', 'A'] }\n" +
         initial;
}

/// The slide goes through where B is drawn, so B stays at y = 0.05.
TEST(InitialState, AssemblesFromAGivenAngleAndItsRate) {
  for (const double angle : {0.3, 1.2, -0.8}) {
    Mechanism m(read_mechanism("m", slider_crank("[initial]\npositions = { theta = " + std::to_string(angle) +
                                                 " }\nvelocities = { theta = 10 }\n")));
    const State s = initial_state(m, 0.0);
    const double ax = 0.2 * std::cos(angle), ay = 0.2 * std::sin(angle), y = 0.05 - ay,
                 x = ax + std::sqrt(0.36 - y * y);
    EXPECT_NEAR(s.q[m.coordinate(2)], ax, 1e-10);
    EXPECT_NEAR(s.q[m.coordinate(2) + 1], ay, 1e-10);
    EXPECT_NEAR(s.q[m.coordinate(3)], x, 1e-10);
    EXPECT_NEAR(s.v[m.coordinate(3)], -10.0 * ay + y / std::sqrt(0.36 - y * y) * 10.0 * ax, 1e-9);
    EXPECT_EQ(s.q[m.numbering().relative[0]], angle);
    EXPECT_EQ(s.v[m.numbering().relative[0]], 10.0);
  }
}

TEST(InitialState, TakesTheNearestWhereNothingIsGiven) {
  Mechanism m(read_mechanism("m", slider_crank("")));
  const State s = initial_state(m, 0.0);
  EXPECT_NEAR(s.q.segment(m.coordinate(2), 2).norm(), 0.2, 1e-10);
  EXPECT_LT((s.q - m.described_state().q).norm(), 0.2);
  EXPECT_EQ(s.v.norm(), 0.0);
}

TEST(InitialState, LeavesADrawingThatFitsAsItIs) {
  Mechanism m(read_mechanism("linkage", four_bar::text(300)));
  const State s = initial_state(m, 0.0), drawn = m.described_state();
  EXPECT_EQ(s.q, drawn.q);
  EXPECT_EQ(s.v, drawn.v);
}

TEST(InitialState, SaysWhatCanNotBe) {
  const auto start_refused = [](const std::string& text, const std::vector<std::string>& says) {
    return refuses(ErrorCode::invalid_argument, says, [&] {
      Mechanism m(read_mechanism("m", text));
      initial_state(m, 0.0);
    });
  };
  EXPECT_TRUE(start_refused(
      slider_crank("[initial]\npositions = { 'B.x' = 2.0 }\n"),
      {"m:21: the mechanism can't be assembled with B.x = 2: constraint 'distance ", "is off by"}));
  EXPECT_TRUE(start_refused(slider_crank("[initial]\nvelocities = { 'B.y' = 1.0 }\n"),
                            {"m:21: no velocities fit the constraints with B.y = 1: constraint 'joint slide: "
                             "across 1' (m:13) is off by 1 m/s"}));
  EXPECT_TRUE(start_refused(slider_crank("[initial]\npositions = { 'C.x' = 2.0 }\n"),
                            {"'C' is not there", "A, B, O, X"}));
  EXPECT_TRUE(
      start_refused(slider_crank("[initial]\npositions = { 'B.z' = 2.0 }\n"), {"the axis 'z'", "x or y"}));
  EXPECT_TRUE(start_refused(slider_crank("[initial]\npositions = { 'O.x' = 2.0 }\n"), {"of a fixed point"}));
}

std::string rod_at(const std::string& p, const std::string& more = "") {
  return "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nP = { " + p +
         " }\n[rods]\nrod = { points = ['O', 'P'], mass = 1 }\n" + more;
}

State started(const std::string& text) {
  Mechanism m(read_mechanism("m", text));
  return initial_state(m, 0.0);
}

testing::AssertionResult start_refused(const std::string& text, const std::string& says) {
  return refuses(ErrorCode::invalid_argument, {says}, [&] { started(text); });
}

/// The rod's gradient by P.y is zero as drawn, or nearly so.
TEST(InitialState, FindsItsWayFromADrawingThatHasNoGradient) {
  for (const char* at : {"at = [1, 0]", "at = [1, 6e-17]", "at = [1, -6e-17]"})
    for (const double x : {0.5, -0.5, 0.99}) {
      const std::string text = rod_at(at, "[initial.positions]\n'P.x' = " + std::to_string(x) + "\n");
      const State s = started(text);
      EXPECT_EQ(s.q[0], x) << at;
      EXPECT_NEAR(std::abs(s.q[1]), std::sqrt(1.0 - x * x), 1e-10) << at;
      EXPECT_EQ(s.q, started(text).q) << "the same side in every run";
    }
  EXPECT_NEAR(std::abs(started(rod_at("at = [0, 1e-9]", "[initial.positions]\n'P.y' = 5e-10\n")).q[0]),
              std::sqrt(0.75) * 1e-9, 1e-18);
}

/// All that may move in an equation is given, or its gradient has no part along what is not.
TEST(InitialState, RefusesGivenValuesThatLeaveAnEquationNothing) {
  EXPECT_TRUE(start_refused(
      rod_at("at = [1, 0]", "[initial.positions]\n'P.x' = 2\n"),
      "m:8: the mechanism can't be assembled with P.x = 2: constraint 'body rod: P . P' (m:6) is "
      "off by 1 m"));
  EXPECT_TRUE(start_refused(
      rod_at("at = [1, 0]", "[initial.positions]\n'P.x' = 0.5\n'P.y' = 0.5\n"),
      "with P.x = 0.5, P.y = 0.5 (m:9): constraint 'body rod: P . P' (m:6) is off by 0.292893 m"));
  EXPECT_TRUE(start_refused(
      rod_at("at = [1, 0], velocity = [1, 0]"),
      "m:4: no velocities fit the constraints with P.x = 1, P.y = 0: constraint 'body rod: P . P' "
      "(m:6) is off by 1 m/s"));
  EXPECT_TRUE(
      start_refused(rod_at("at = [1, 0]", "[initial.velocities]\n'P.x' = 1\n"), "with P.x = 1: constraint"));
  EXPECT_TRUE(start_refused(rod_at("at = [1, 0]", "[distances]\nd = { points = ['O', 'P'], length = 2 }\n"),
                            "the mechanism can't be assembled: constraint '"));
}

TEST(InitialState, RefusesAFourBarWhosePointsMoveApart) {
  EXPECT_TRUE(start_refused(
      "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nA = { at = [0, 1], velocity = [1, 0] }\n"
      "B = { at = [1, 1], velocity = [2, 0] }\nC = { at = [1, 0], fixed = true }\n[rods]\n"
      "r = { points = ['O', 'A'], mass = 1 }\ns = { points = ['A', 'B'], mass = 1 }\n"
      "t = { points = ['B', 'C'], mass = 1 }\n",
      "m:4: no velocities fit the constraints with A.x = 1, A.y = 0, B.x = 2 (m:5), B.y = 0 (m:5): "
      "constraint "
      "'body s: B . B' (m:9) is off by 1 m/s"));
}

/// Both equations are off where the assembly comes nearest, although neither is redundant by its gradient
/// alone; one that is there twice contradicts nothing.
TEST(InitialState, TellsContradictionsFromRedundantConstraints) {
  const auto found = [](double length) {
    Mechanism m(read_mechanism(
        "m", rod_at("at = [1, 0]",
                    "[distances]\nd = { points = ['O', 'P'], length = " + std::to_string(length) + " }\n")));
    return assembled(m, 0.0).contradictions;
  };
  EXPECT_TRUE(found(1.0).empty());
  const auto two = found(2.0);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_GT(std::abs(two[0].off), 0.1);
  EXPECT_GT(std::abs(two[1].off), 0.1);
}

/// A constraint that is there twice, and a motion that a drive prescribes.
TEST(InitialState, TakesRedundantConstraintsAndDrives) {
  Mechanism m(
      read_mechanism("m", slider_crank("[distances.again]\npoints = ['O', 'A']\nlength = 0.2\n"
                                       "[inputs]\nturn = { unit = 'rad', polynomial = [0.5, 3] }\n"
                                       "[drives]\nmotor = { coordinate = 'theta', motion = 'turn' }\n")));
  const State s = initial_state(m, 0.1);
  EXPECT_NEAR(s.q[m.numbering().relative[0]], 0.8, 1e-10);
  EXPECT_NEAR(s.v[m.numbering().relative[0]], 3.0, 1e-10);
  EXPECT_NEAR(s.v[m.coordinate(2)], -3.0 * 0.2 * std::sin(0.8), 1e-10);
}

}  // namespace
}  // namespace tandem::mbs
