// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What every linear solver does, against a dense one.
#include "tandem/mbs/sparse/linear_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>

#include "refusal.hpp"
#include "solver_bench.hpp"
#include "thesis_solvers/thesis_solvers.hpp"

namespace tandem::mbs {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::pattern_of;
using test::SolverBench;

/// A symmetric matrix with a band of that width after a shuffle of its rows; positive definite by its
/// diagonal.
MatrixXd shuffled_band(int size, int width, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  std::vector<int> order(static_cast<std::size_t>(size));
  for (int i = 0; i < size; ++i) order[i] = i;
  if (seed % 2 == 1) std::shuffle(order.begin(), order.end(), random);
  MatrixXd a = MatrixXd::Zero(size, size);
  for (int c = 0; c < size; ++c)
    for (int r = c; r < std::min(size, c + width + 1); ++r)
      a(order[r], order[c]) = a(order[c], order[r]) = r == c ? 2.0 * width + u(random) : u(random);
  return a;
}

const bool has_all = test::add_thesis_solvers();

class Solver : public testing::TestWithParam<std::string> {
 protected:
  SolverBench make(const Pattern& pattern) const {
    return {GetParam(), MatrixKind::positive_definite, pattern};
  }
};
INSTANTIATE_TEST_SUITE_P(Each, Solver, testing::ValuesIn(solver_names(MatrixKind::positive_definite)),
                         [](const auto& p) { return p.param; });

/// Diagonally dominant: the condition is below 10, so errors are a few hundred eps.
TEST_P(Solver, AgreesWithADenseOne) {
  for (const int size : {1, 2, 7, 8, 9, 40, 41})  // what is left between two ends is even or odd
    for (const int width : {1, 2, 3, 4, 5, 6, 7, 8, 9, 12}) {
      const MatrixXd shape = shuffled_band(size, width, static_cast<unsigned>(size + width));
      SolverBench solver = make(pattern_of(shape));
      for (const double scale : {1.0, 0.3}) {  // values change, the pattern stays
        MatrixXd a = shape;
        a.diagonal() *= 1.0 + scale;
        ASSERT_EQ(solver.factorize(a), -1);
        for (const double first : {1.0, -2.0}) {
          const VectorXd b = VectorXd::LinSpaced(size, first, 3.0), x = solver.solve(b);
          EXPECT_LT((a * x - b).norm(), 1e-12 * b.norm()) << size << " " << width;
        }
      }
    }
}

TEST_P(Solver, TellsTheColumnOfASingularMatrixAndGoesOnAfterIt) {
  for (const int size : {6, 7}) {
    const MatrixXd a = shuffled_band(size, 2, 4);
    const VectorXd b = VectorXd::Ones(size);
    SolverBench solver = make(pattern_of(a));
    for (int column = 0; column < size; ++column) {
      MatrixXd singular = a;
      singular.row(column).setZero();
      singular.col(column).setZero();
      EXPECT_EQ(solver.factorize(singular), column);
      ASSERT_EQ(solver.factorize(a), -1);
      EXPECT_LT((a * solver.solve(b) - b).norm(), 1e-12);
    }
  }
}

TEST_P(Solver, TakesAnotherPattern) {
  SolverBench solver = make(pattern_of(MatrixXd::Identity(3, 3)));
  for (const int size : {9, 4, 15}) {
    const MatrixXd a = shuffled_band(size, 3, 1);
    solver.analyze(pattern_of(a));
    ASSERT_EQ(solver.factorize(a), -1);
    EXPECT_LT((a * solver.solve(VectorXd::Ones(size)) - VectorXd::Ones(size)).norm(), 1e-12);
  }
}

/// The second matrix is factorized with the pivots that the first one needs, by those that keep them.
TEST(SolverMemory, AnotherSolverThatHasItGoesOnWithTheSameBits) {
  MatrixXd first = shuffled_band(12, 3, 5), second = first;
  first.diagonal() *= 1e-6;
  for (const std::string& name : solver_names(MatrixKind::unsymmetric)) {
    SolverBench solver(name, MatrixKind::unsymmetric, pattern_of(second)),
        other(name, MatrixKind::unsymmetric, pattern_of(second));
    const VectorXd b = VectorXd::LinSpaced(12, 1.0, 3.0);
    ASSERT_EQ(solver.factorize(first), -1) << name;
    ASSERT_EQ(solver.factorize(second), -1) << name;
    ASSERT_EQ(other.factorize(second), -1) << name;
    other.recall(solver.memory());
    ASSERT_EQ(other.factorize(second), -1) << name;
    EXPECT_EQ(other.solve(b), solver.solve(b)) << name;
    EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"another model"}, [&] {
      other.recall({1.0, 2.0});
    })) << name;
  }
}

TEST(MakeSolver, RefusesANameThatIsNotThereOrNotForTheMatrix) {
  using test::refuses;
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'kul'", "did you mean 'klu'?", "band"},
                      [] { make_solver("kul", MatrixKind::positive_definite); }));
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"'band'"}, [] { make_solver("band", MatrixKind::unsymmetric); }));
}

TEST(MakeSolver, KnowsThoseThatWereAddedByTheirNames) {
  const auto names = solver_names(MatrixKind::positive_definite);
  EXPECT_NE(std::find(names.begin(), names.end(), "ldlt"), names.end());
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"'klu'", "another name"},
                            [] { add_solver("klu", MatrixKind::unsymmetric, test::ldlt); }));
}

}  // namespace
}  // namespace tandem::mbs
