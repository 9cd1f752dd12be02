// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/condensed_states.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "tandem/mbs/sparse/tangent.hpp"

namespace tandem::mbs {
namespace {

/// Three variables under one equation, and a state whose column is -6 times its row, as of a force that
/// follows it and a rate that follows the motion: what is left is symmetric, so that the solution is exact.
struct Problem {
  Structure structure;
  ModelMatrices at;
  Eigen::Matrix4d whole;
  TangentFactors factors{0.1, 0.01, 1e4};

  static Structure make() {
    Structure s;
    s.coordinates = s.variables = 4;
    s.constraints = 1;
    s.mass = {Pattern(4, 4, {{0, 0}, {1, 1}, {2, 2}, {3, 3}}), {2.0, 3.0, 4.0, 1.0}};
    s.jacobian = Pattern(4, 1, {{0, 0}, {1, 0}});
    std::vector<std::pair<int, int>> all;
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) all.emplace_back(r, c);
    s.stiffness = Pattern(4, 4, all);
    s.states = {3};
    return s;
  }
  Problem() : structure(make()), at(structure) {
    Eigen::Matrix4d k = Eigen::Matrix4d::Zero(), c = k;
    k.diagonal() << 50.0, 60.0, 70.0, 0.0;
    k(0, 2) = k(2, 0) = -20.0;
    c.diagonal() << 1.0, 2.0, 3.0, 5.0;
    c.row(3).head(3) << 0.5, -1.5, 2.5;
    c.col(3).head(3) = -6.0 * c.row(3).head(3).transpose();
    Eigen::Map<Eigen::Matrix4d>(at.stiffness.data()) = k;
    Eigen::Map<Eigen::Matrix4d>(at.damping.data()) = c;
    at.jacobian = {1.0, -2.0};
    const Eigen::Vector4d phi(1.0, -2.0, 0.0, 0.0), m(2.0, 3.0, 4.0, 1.0);
    whole = factors.damping * c + factors.stiffness * k + factors.penalty * phi * phi.transpose();
    whole.diagonal() += m;
  }
};

TEST(CondensedStates, SolutionIsThatOfTheWholeMatrix) {
  for (const char* solver : {"auto", "band", "prepared"}) {
    Problem p;
    Tangent tangent(p.structure, make_solver(solver, MatrixKind::positive_definite));
    tangent.assemble(p.at, p.factors);
    ASSERT_EQ(tangent.factorize(), -1);
    const Eigen::Vector4d b(1.0, 2.0, -3.0, 0.7);
    Eigen::Vector4d x = b;
    tangent.solve(x.data());
    EXPECT_LT((p.whole * x - b).norm(), 1e-9) << solver;
  }
}

TEST(CondensedStates, AreRecalledWithTheTangent) {
  Problem p;
  Tangent tangent(p.structure, make_solver("prepared", MatrixKind::positive_definite));
  tangent.assemble(p.at, p.factors);
  tangent.factorize();
  const std::vector<double> kept = tangent.values();
  Eigen::Vector4d first(1.0, 2.0, -3.0, 0.7), again = first;
  tangent.solve(first.data());
  p.at.damping[3] = 9.0;
  tangent.assemble(p.at, p.factors);
  tangent.factorize();
  tangent.recall(kept);
  tangent.solve(again.data());
  EXPECT_EQ(first, again);
}

}  // namespace
}  // namespace tandem::mbs
