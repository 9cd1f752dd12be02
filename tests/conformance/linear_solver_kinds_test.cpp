// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Every linear solver with every kind of matrix that it takes, against residuals in extended precision.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>
#include <random>

#include "solver_bench.hpp"
#include "thesis_solvers/thesis_solvers.hpp"

namespace tandem::mbs {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::pattern_of;
using test::SolverBench;

struct KindCase {
  std::string name;
  MatrixKind kind;
};

std::string kind_name(MatrixKind kind) {
  return kind == MatrixKind::positive_definite ? "definite"
         : kind == MatrixKind::symmetric       ? "symmetric"
                                               : "unsymmetric";
}

void PrintTo(const KindCase& c, std::ostream* out) { *out << c.name << ", " << kind_name(c.kind); }

std::vector<KindCase> kind_cases(const std::vector<MatrixKind>& kinds) {
  test::add_thesis_solvers();
  std::vector<KindCase> all;
  for (const MatrixKind kind : kinds)
    for (const std::string& name : solver_names(kind)) all.push_back({name, kind});
  return all;
}

class EachKind : public testing::TestWithParam<KindCase> {
 protected:
  SolverBench make(const Pattern& pattern) const { return {GetParam().name, GetParam().kind, pattern}; }
};
class WithPivots : public EachKind {};
using enum MatrixKind;
const auto name_of = [](const auto& p) { return p.param.name + "_" + kind_name(p.param.kind); };
INSTANTIATE_TEST_SUITE_P(Solvers, EachKind,
                         testing::ValuesIn(kind_cases({positive_definite, symmetric, unsymmetric})), name_of);
INSTANTIATE_TEST_SUITE_P(Solvers, WithPivots, testing::ValuesIn(kind_cases({symmetric, unsymmetric})),
                         name_of);

/// Sparse, about three entries a row beside the diagonal. Positive definite: by its diagonal. Else the signs
/// of the diagonal alternate, and some of it is zero, with a large entry beside it so that the matrix is not
/// singular.
MatrixXd random_matrix(MatrixKind kind, int size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  std::uniform_int_distribution<int> place(0, size - 1);
  MatrixXd a = MatrixXd::Zero(size, size);
  for (int k = 0; k < 3 * size; ++k) a(place(random), place(random)) = u(random);
  if (kind != MatrixKind::unsymmetric) a = (a + a.transpose()).eval();
  for (int i = 0; i < size; ++i) {
    const double size_of_row = a.row(i).cwiseAbs().sum() + 0.1;
    a(i, i) = kind == MatrixKind::positive_definite || i % 2 == 0 ? size_of_row : -size_of_row;
  }
  if (kind != MatrixKind::positive_definite)
    for (int i = 0; i + 1 < size; i += 5) a(i, i) = 0.0, a(i, i + 1) = a(i + 1, i) = 10.0;
  return a;
}

/// |A x - b| / (|A| |x| + |b|), summed in extended precision: how far from A and b the problem is that x
/// solves.
double backward_error(const MatrixXd& a, const VectorXd& x, const VectorXd& b) {
  using Extended = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  const Extended residual = a.cast<long double>() * x.cast<long double>() - b.cast<long double>();
  return static_cast<double>(residual.norm()) / (a.norm() * x.norm() + b.norm());
}

/// Elimination errs by about n eps times the growth of its numbers (N. Higham, Accuracy and Stability of
/// Numerical Algorithms, 2002, th. 9.5): n up to 200, and growth up to some tens as pivots are chosen among
/// those that keep the matrix sparse.
constexpr double rounding = 200 * 30 * std::numeric_limits<double>::epsilon();

TEST_P(EachKind, SolvesRandomSparseSystems) {
  for (const int size : {1, 2, 3, 5, 10, 23, 50, 81, 120, 200})
    for (unsigned seed = 0; seed < 4; ++seed) {
      const MatrixXd a = random_matrix(GetParam().kind, size, seed);
      SolverBench solver = make(pattern_of(a));
      ASSERT_EQ(solver.factorize(a), -1) << size << " " << seed;
      const VectorXd b = VectorXd::LinSpaced(size, 1.0, -2.0);
      EXPECT_LT(backward_error(a, solver.solve(b), b), rounding) << size << " " << seed;
    }
}

/// From one matrix to another on the same pattern: pivots of the first need not be any good for the last.
TEST_P(EachKind, FollowsValuesThatDrift) {
  const int size = 60;
  const MatrixXd from = random_matrix(GetParam().kind, size, 7);
  MatrixXd to = random_matrix(GetParam().kind, size, 8);
  to = (from.array() != 0.0).select(to + from * 0.1, to).eval();
  SolverBench solver = make(pattern_of(from.cwiseAbs() + to.cwiseAbs()));
  const VectorXd b = VectorXd::LinSpaced(size, 1.0, -2.0);
  for (int k = 0; k <= 200; ++k) {
    const MatrixXd a = from + k / 200.0 * (to - from);
    ASSERT_EQ(solver.factorize(a), -1) << k;
    for (int side = 0; side < 2; ++side)
      EXPECT_LT(backward_error(a, solver.solve(b), b), rounding) << "at " << k;
  }
}

/// A definite matrix has no such pivots. Where a pivot shrinks to 1e-13 of its neighbours, elimination with
/// it loses 13 digits.
TEST_P(WithPivots, GoesOnWhereOldPivotsTurnBad) {
  const int size = 12;
  MatrixXd a = random_matrix(GetParam().kind, size, 3);
  a.diagonal().setConstant(5.0);
  SolverBench solver = make(pattern_of(a));
  const VectorXd b = VectorXd::LinSpaced(size, 1.0, -2.0);
  for (const double shrunk : {1.0, 1e-3, 1e-13, 1e-15, 1.0}) {
    MatrixXd now = a;
    now.diagonal() *= shrunk;
    ASSERT_EQ(solver.factorize(now), -1) << shrunk;
    EXPECT_LT(backward_error(now, solver.solve(b), b), rounding) << shrunk;
  }
}

TEST_P(EachKind, TellsAColumnThatVanishes) {
  const int size = 30;
  MatrixXd a = random_matrix(GetParam().kind, size, 5);
  SolverBench solver = make(pattern_of(a));
  for (const int column : {0, 11, 29}) {
    MatrixXd singular = a;
    singular.row(column).setZero();
    singular.col(column).setZero();
    EXPECT_EQ(solver.factorize(singular), column);
    EXPECT_EQ(solver.factorize(a), -1);
  }
}

}  // namespace
}  // namespace tandem::mbs
