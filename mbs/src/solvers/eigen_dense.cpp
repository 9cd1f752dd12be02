// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Dense>

#include "solvers.hpp"

namespace tandem::mbs::solvers {
namespace {

using Matrix = Eigen::MatrixXd;

Layout dense_layout(int n) {
  Layout all;
  for (int column = 0; column < n; ++column)
    for (int row = 0; row < n; ++row) all.emplace_back(row, column);
  return all;
}

class EigenCholesky final : public LinearSolver {
 public:
  void analyze(const Pattern& pattern) override { n_ = pattern.columns(); }
  Layout layout() const override { return dense_layout(n_); }
  int factorize(double* values) override {
    const Eigen::Map<const Matrix> a(values, n_, n_);
    solver_.compute(a);
    return solver_.info() == Eigen::Success ? -1 : bad_pivot(a);
  }
  void solve(double* b) override {
    const Eigen::Map<Eigen::VectorXd> x(b, n_);
    solver_.solveInPlace(x);
  }

 private:
  /// Eigen doesn't tell which: the first whose leading block has no factorization.
  int bad_pivot(const Matrix& a) const {
    int k = 1;
    while (k < n_ && Eigen::LLT<Matrix>(a.topLeftCorner(k, k)).info() == Eigen::Success) ++k;
    return k - 1;
  }
  int n_ = 0;
  Eigen::LLT<Matrix> solver_;
};

class EigenLu final : public LinearSolver {
 public:
  void analyze(const Pattern& pattern) override {
    n_ = pattern.columns();
    x_.resize(n_);
  }
  Layout layout() const override { return dense_layout(n_); }
  int factorize(double* values) override {
    solver_.compute(Eigen::Map<const Matrix>(values, n_, n_));
    for (int k = 0; k < n_; ++k)
      if (!(solver_.matrixLU()(k, k) != 0.0)) return k;
    return -1;
  }
  void solve(double* b) override {
    Eigen::Map<Eigen::VectorXd> x(b, n_);
    x_ = solver_.solve(x);
    x = x_;
  }

 private:
  int n_ = 0;
  Eigen::PartialPivLU<Matrix> solver_;
  Eigen::VectorXd x_;
};

}  // namespace

std::unique_ptr<LinearSolver> eigen_dense(MatrixKind kind) {
  if (kind == MatrixKind::positive_definite) return std::make_unique<EigenCholesky>();
  return std::make_unique<EigenLu>();
}

}  // namespace tandem::mbs::solvers
