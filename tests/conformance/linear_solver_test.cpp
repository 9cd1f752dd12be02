// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What every linear solver does, against a dense one.
#include "tandem/mbs/sparse/linear_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>

#include "refusal.hpp"

namespace tandem::mbs {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

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

std::vector<double> values_of(const MatrixXd& a, const Pattern& pattern) {
  std::vector<double> values;
  for (const auto& [row, column] : pattern.entries()) values.push_back(a(row, column));
  return values;
}

Pattern pattern_of(const MatrixXd& a, bool lower) {
  std::vector<std::pair<int, int>> entries;
  for (int c = 0; c < a.cols(); ++c)
    for (int r = 0; r < a.rows(); ++r)
      if (a(r, c) != 0.0 || r == c) entries.emplace_back(r, c);
  const Pattern whole(static_cast<int>(a.rows()), static_cast<int>(a.cols()), entries);
  return lower ? whole.lower() : whole;
}

class Solver : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<LinearSolver> make() const {
    return make_solver(GetParam(), MatrixKind::positive_definite);
  }
};
INSTANTIATE_TEST_SUITE_P(Each, Solver, testing::ValuesIn(solver_names(MatrixKind::positive_definite)),
                         [](const auto& p) { return p.param; });

/// Diagonally dominant: the condition is below 10, so errors are a few hundred eps.
TEST_P(Solver, AgreesWithADenseOne) {
  for (const int size : {1, 2, 7, 40})
    for (const int width : {1, 2, 3, 5, 9}) {
      const auto solver = make();
      const MatrixXd shape = shuffled_band(size, width, static_cast<unsigned>(size + width));
      const Pattern pattern = pattern_of(shape, solver->lower());
      solver->analyze(pattern);
      for (const double scale : {1.0, 0.3}) {  // values change, the pattern stays
        MatrixXd a = shape;
        a.diagonal() *= 1.0 + scale;
        ASSERT_EQ(solver->factorize(values_of(a, pattern).data()), -1);
        for (const double first : {1.0, -2.0}) {
          VectorXd b = VectorXd::LinSpaced(size, first, 3.0), x = b;
          solver->solve(x.data());
          EXPECT_LT((a * x - b).norm(), 1e-12 * b.norm()) << size << " " << width;
        }
      }
    }
}

TEST_P(Solver, TellsASingularMatrixAndGoesOnAfterIt) {
  const auto solver = make();
  MatrixXd a = shuffled_band(6, 2, 4);
  const Pattern pattern = pattern_of(a, solver->lower());
  solver->analyze(pattern);
  MatrixXd singular = a;
  singular.row(3).setZero();
  singular.col(3).setZero();
  EXPECT_GE(solver->factorize(values_of(singular, pattern).data()), 0);
  ASSERT_EQ(solver->factorize(values_of(a, pattern).data()), -1);
  VectorXd x = VectorXd::Ones(6);
  solver->solve(x.data());
  EXPECT_LT((a * x - VectorXd::Ones(6)).norm(), 1e-12);
}

TEST_P(Solver, TakesAnotherPattern) {
  const auto solver = make();
  for (const int size : {9, 4, 15}) {
    const MatrixXd a = shuffled_band(size, 3, 1);
    const Pattern pattern = pattern_of(a, solver->lower());
    solver->analyze(pattern);
    ASSERT_EQ(solver->factorize(values_of(a, pattern).data()), -1);
    VectorXd x = VectorXd::Ones(size);
    solver->solve(x.data());
    EXPECT_LT((a * x - VectorXd::Ones(size)).norm(), 1e-12);
  }
}

TEST(MakeSolver, RefusesANameThatIsNotThereOrNotForTheMatrix) {
  using test::refuses;
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'kul'", "did you mean 'klu'?", "band"},
                      [] { make_solver("kul", MatrixKind::positive_definite); }));
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"'band'"}, [] { make_solver("band", MatrixKind::unsymmetric); }));
}

}  // namespace
}  // namespace tandem::mbs
