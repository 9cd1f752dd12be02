// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "outputs_at_start.hpp"

namespace tandem::mbs {
namespace {

using Eigen::VectorXd;

/// A double pendulum of two rods with a force on its tip, one along a line and a torque.
const std::string pushed_text =
    "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nA = { at = [1, 0] }\nB = { at = [2, 1], "
    "velocity = "
    "[0.7, 0] }\n[rods]\na = { points = ['O', 'A'], mass = 2 }\nb = { points = ['A', 'B'], mass = 3 "
    "}\n[vectors]\nX = "
    "{ at = [1, 0], fixed = true }\n[angles]\nt = { from = 'X', to = ['O', 'A'] }\n[inputs]\nF = { unit = "
    "'N', value = "
    "0 }\nP = { unit = 'N', value = 0 }\nM = { unit = 'N m', value = 0 }\n[forces]\nf = { point = 'B', "
    "direction = "
    "[0.6, 0.8], magnitude = 'F', gain = 2 }\np = { between = ['O', 'B'], magnitude = 'P' }\nm = { "
    "coordinate = 't', "
    "magnitude = 'M' }\n[outputs]\n";

/// What an input of 1 adds to accelerations, in Newton's equations too; and its rate, beside that of a moved state.
TEST(Accelerances, AreWhatAForceAdds) {
  const std::string names[] = {"F", "P", "M"};
  std::string text = pushed_text;
  for (const std::string& n : names)
    text += n + " = { accelerance = 'B.x', input = '" + n + "', gain = 3 }\n";
  text += "a = { acceleration = 'B.x', gain = 3 }\n";
  const VectorXd free = outputs(text);
  for (int k = 0; k < 3; ++k) {
    std::string pushed = text;
    const std::string value = names[k] + " = { unit = '" + (k == 2 ? "N m" : "N") + "', value = ";
    pushed.replace(pushed.find(value + "0"), value.size() + 1, value + "1");
    EXPECT_NEAR(free[k], outputs(pushed)[3] - free[3], 1e-9 * std::abs(free[k])) << names[k];
  }
  Mechanism m(read_mechanism("m", text));
  Outputs all(m);
  EXPECT_EQ(all.unit(0), "m/s^2/N");
  EXPECT_EQ(all.unit(2), "m/s^2/(N m)");
  const auto values = [&](double ahead) {
    State s = initial_state(m, 0.0);
    s.q += ahead * s.v;
    VectorXd y(4);
    all.evaluate(s, y.data());
    return y;
  };
  VectorXd rate(4);
  all.derivatives(initial_state(m, 0.0), 1, rate.data());
  const VectorXd difference = (values(1e-4) - values(-1e-4)) / 2e-4;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(rate[k], difference[k], 1e-6 * std::abs(rate[k])) << k;
}

/// Of one mass alone and of one that redundant equations hold, beside one that is far heavier.
TEST(Accelerances, NeedNoRegularEquations) {
  const std::string body =
      "[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [2, 0] }\nQ = { at = [5, 0] }\n[masses]\nq = "
      "{ point = "
      "'Q', mass = 1e9, free = true }\nm = { point = 'P', mass = 4, free = true }\n[inputs]\nF = { unit = "
      "'N', value = 0 }\n[forces]\nf = { point = 'P', "
      "direction = [0, 1], magnitude = 'F' }\n[outputs]\nx = { accelerance = 'P.x', input = 'F' }\ny = { "
      "accelerance = 'P.y', input = 'F' }\n";
  for (const std::string& held :
       {std::string(),
        std::string("[distances]\na = { points = ['O', 'P'] }\nb = { points = ['O', 'P'] }\n")}) {
    const VectorXd y = outputs("dimension = 2\n" + body + held);
    EXPECT_NEAR(y[0], 0.0, 1e-15);
    EXPECT_NEAR(y[1], 0.25, 1e-14);
  }
}

}  // namespace
}  // namespace tandem::mbs
