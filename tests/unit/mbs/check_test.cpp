// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a mechanism must have to be assembled.
#include <gtest/gtest.h>

#include "refusal.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

using test::refuses;

TEST(Check, RefusesAMechanismInWhichNothingMoves) {
  const std::string fixed = "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\n";
  for (const char* more :
       {"P = { at = [1, 0], fixed = true }\n[rods]\nr = { points = ['O', 'P'], mass = 1 }\n",
        "[masses]\nm = { point = 'O', mass = 1 }\n"})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument,
                        {"m:", "every point and vector is fixed", "one that moves"},
                        [&] { Mechanism(read_mechanism("m", fixed + more)); }));
}

/// Whether it holds as drawn or not.
TEST(Check, RefusesAnEquationOfWhatIsFixedAlone) {
  const std::string text =
      "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nQ = { at = [2, 0], fixed = true }\n"
      "P = { at = [1, 0] }\n[rods]\nr = { points = ['O', 'P'], mass = 1 }\n"
      "[vectors]\ne = { at = [1, 0], fixed = true }\nf = { at = [1, 1], fixed = true }\n";
  for (const auto& [more, name] :
       {std::pair("[fixed_angles]\nx = { edges = ['e', 'f'] }\n", "fixed angle x"),
        {"[products]\nx = { edges = ['e', 'f'] }\n", "product x"},
        {"[products]\nx = { edges = ['e', ['O', 'Q']], value = 7 }\n", "product x"},
        {"[distances]\nx = { points = ['O', 'Q'] }\n", "distance x"}})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument,
                        {"m:12: constraint '" + std::string(name) + "'", "fixed, all of them", "that moves"},
                        [&, more = more] { Mechanism(read_mechanism("m", text + more)); }));
  EXPECT_NO_THROW(Mechanism(read_mechanism("m", text + "[angles]\nx = { from = 'e', to = 'f' }\n")));
}

/// What holds a body in its place, wholly or in part; a drive does, a line without force does not.
TEST(Check, RefusesWhatNothingHolds) {
  const std::string
      loose =
          "[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [1, 0] }\nQ = { at = [5, 5] }\nR = { at = "
          "[6, 5] }\n"
          "[rods]\nrod = { points = ['O', 'P'], mass = 1 }\n[rods.loose]\npoints = ['Q', 'R']\nmass = 1\n",
      refusal = "m:9: body 'loose' is connected to nothing that is fixed";
  const auto build = [](const std::string& text) {
    return [=] { Mechanism(read_mechanism("m", "dimension = 2\n" + text)); };
  };
  for (const char* more :
       {"", "[forces]\nf = { between = ['O', 'Q'], magnitude = 0 }\n",
        "[springs]\ns = { points = ['O', 'Q'], stiffness = 0 }\n",
        "[products]\np = { edges = [['O', 'P'], ['Q', 'R']] }\n", "[lengths]\nl = { points = ['O', 'Q'] }\n",
        "[fixed_angles]\na = { edges = [['O', 'P'], ['Q', 'R']] }\n",
        "[forces]\nf = { point = 'Q', direction = [1, 0], magnitude = 1 }\n"})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {refusal, "free = true"}, build(loose + more))) << more;
  for (const char* more :
       {"free = true\n", "[forces]\nf = { between = ['O', 'Q'], magnitude = 1 }\n",
        "[springs]\ns = { points = ['O', 'Q'], stiffness = 1 }\n",
        "[lengths]\nl = { points = ['O', 'Q'] }\n[springs]\ns = { coordinate = 'l', stiffness = 1 }\n",
        "[distances]\nd = { points = ['O', 'Q'] }\n",
        "[inputs]\nu = { unit = 'm', value = 5 }\n[drives]\nd = { coordinate = 'Q.x', motion = 'u' }\n"})
    EXPECT_NO_THROW(build(loose + more)()) << more;
  const std::string mass =
      "[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [1, 0] }\nQ = { at = [5, 5] }\n"
      "[rods]\nrod = { points = ['O', 'P'], mass = 1 }\n[masses.m]\npoint = 'Q'\nmass = 1\n";
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"m:8: mass 'm' is connected to nothing that is fixed"},
                      build(mass)));
  EXPECT_NO_THROW(build(mass + "free = true\n")());
}

}  // namespace
}  // namespace tandem::mbs
