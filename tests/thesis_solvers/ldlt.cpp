// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/SparseCholesky>
#include <algorithm>

#include "thesis_solvers/thesis_solvers.hpp"

namespace tandem::test {
namespace {

using namespace mbs;

/// Eigen's simplicial LDL^T with AMD ordering.
class Ldlt final : public LinearSolver {
 public:
  void analyze(const Pattern& pattern) override {
    pattern_ = pattern.lower();
    solver_.analyzePattern(matrix(std::vector<double>(pattern_.size(), 1.0).data()));
  }
  Layout layout() const override { return pattern_.entries(); }

  int factorize(double* values) override {
    solver_.factorize(matrix(values));
    if (solver_.info() == Eigen::Success) return -1;
    const Eigen::VectorXd pivots = solver_.vectorD();  // it stops at one that is zero
    const auto stop = std::find(pivots.begin(), pivots.end(), 0.0) - pivots.begin();
    return solver_.permutationPinv().indices()[std::min(stop, pivots.size() - 1)];
  }
  void solve(double* b) override {
    Eigen::Map<Eigen::VectorXd> x(b, pattern_.columns());
    x = solver_.solve(x).eval();
  }

 private:
  using Lower = Eigen::SparseMatrix<double>;
  Eigen::Map<const Lower> matrix(const double* values) const {
    return {pattern_.rows(),          pattern_.columns(),        pattern_.size(),
            pattern_.starts().data(), pattern_.indices().data(), values};
  }
  Pattern pattern_;
  Eigen::SimplicialLDLT<Lower, Eigen::Lower> solver_;
};

}  // namespace

std::unique_ptr<LinearSolver> ldlt(MatrixKind) { return std::make_unique<Ldlt>(); }

}  // namespace tandem::test
