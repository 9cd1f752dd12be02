// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/reduced.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

using Eigen::VectorXd;

/// A double pendulum of two rods with a spring, let go in motion.
const char* const double_pendulum =
    "dimension = 2\ngravity = [0, -9.81]\n[points]\nO = { at = [0, 0], fixed = true }\nA = { at = [1, 0] "
    "}\nB = { at = "
    "[2, 1], velocity = [0.7, 0.3] }\nC = { at = [3, 2], fixed = true }\n[rods]\na = { points = ['O', 'A'], "
    "mass = 2 "
    "}\nb = { points = ['A', 'B'], mass = 3 }\n[vectors]\nX = { at = [1, 0], fixed = true }\n[angles]\nt = { "
    "from = "
    "'X', to = ['O', 'A'] }\n[springs]\ns = { points = ['B', 'C'], free = 1, stiffness = 40, damping = 3 }\n";

VectorXd values_of(const std::vector<int>& variables, const VectorXd& from) {
  VectorXd to(static_cast<Eigen::Index>(variables.size()));
  for (Eigen::Index k = 0; k < to.size(); ++k) to[k] = from[variables[static_cast<std::size_t>(k)]];
  return to;
}

/// By M q'' + Phi_q^T lambda = Q, Phi_q q'' = -gamma, with multipliers.
VectorXd accelerations_of_all(const Mechanism& m, const VectorXd& q, const VectorXd& force,
                              const VectorXd& gamma) {
  const Structure& s = m.structure();
  const Eigen::Index n = force.size(), c = gamma.size();
  std::vector<double> values(static_cast<std::size_t>(s.jacobian_values()));
  VectorXd phi(c), right(n + c);
  m.constraints(q.data(), phi.data(), values.data());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n + c, n + c);
  const auto put = [&](const Pattern& p, const std::vector<double>& of, Eigen::Index first) {
    for (int column = 0; column < p.columns(); ++column)
      for (int k = p.starts()[column]; k < p.starts()[column + 1]; ++k)
        all(p.indices()[k], first + column) = of[static_cast<std::size_t>(k)];
  };
  put(s.mass.pattern, s.mass.values, 0), put(s.jacobian, values, n);
  all.bottomLeftCorner(c, n) = all.topRightCorner(n, c).transpose();
  right << force, -gamma;
  return Eigen::FullPivLU<Eigen::MatrixXd>(all).solve(right).head(n);
}

/// Beside M q'' + Phi_q^T lambda = Q, Phi_q q'' = -gamma in all coordinates; where it stands and where it has moved to.
TEST(Reduced, HasTheAccelerationsOfAllCoordinates) {
  Mechanism m(read_mechanism("m", double_pendulum));
  State s = initial_state(m, 0.0);
  const auto variables = independent_variables(m, s.q, {2}, {4});  // B.x, and the angle
  ASSERT_EQ(variables, (std::vector<int>{2, 4}));
  Reduced reduced(m, variables, s.q);
  VectorXd force(m.structure().variables), gamma(m.structure().constraints);
  for (const double moved : {0.0, 0.2}) {
    VectorXd p = values_of(variables, s.q), u = values_of(variables, s.v);
    p[0] -= moved, p[1] += 2.0 * moved;
    reduced.stand_at(p);
    const VectorXd a = reduced.accelerations(u);
    VectorXd v = VectorXd::Zero(s.q.size());
    v.head(force.size()) = reduced.rates(u);
    m.forces(reduced.q().data(), v.data(), force.data());
    m.constraint_accelerations(reduced.q().data(), v.data(), gamma.data());
    const VectorXd whole = accelerations_of_all(m, reduced.q(), force, gamma);
    EXPECT_LT((a - values_of(variables, whole)).norm(), 1e-9 * a.norm()) << moved;
    EXPECT_LT((reduced.mass() * reduced.answer(VectorXd::Unit(2, 1)) - VectorXd::Unit(2, 1)).norm(), 1e-12);
  }
}

TEST(Reduced, RefusesWhereTheOthersDoNotFollow) {
  Mechanism m(read_mechanism(
      "m",
      "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [0.6, -0.8] "
      "}\n[masses]\nm = { point = 'P', mass = 1 }\n[distances]\nr = { points = ['O', 'P'] }\n"));
  const State s = initial_state(m, 0.0);
  Reduced reduced(m, independent_variables(m, s.q, {0}, {}), s.q);
  reduced.stand_at(VectorXd::Constant(1, 0.9));
  EXPECT_NEAR(reduced.q()[1], -std::sqrt(1.0 - 0.81), 1e-12);
  EXPECT_THROW(reduced.stand_at(VectorXd::Constant(1, 1.1)), Error);
  EXPECT_TRUE(independent_variables(m, s.q, {0, 1}, {}).empty());
}

}  // namespace
}  // namespace tandem::mbs
