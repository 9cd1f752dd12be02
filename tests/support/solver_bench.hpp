// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "memory_of.hpp"
#include "tandem/mbs/sparse/linear_solver.hpp"

namespace tandem::test {

/// Its non-zero entries and the diagonal.
inline mbs::Pattern pattern_of(const Eigen::MatrixXd& a) {
  std::vector<std::pair<int, int>> entries;
  for (int c = 0; c < a.cols(); ++c)
    for (int r = 0; r < a.rows(); ++r)
      if (a(r, c) != 0.0 || r == c) entries.emplace_back(r, c);
  return {static_cast<int>(a.rows()), static_cast<int>(a.cols()), entries};
}

/// A solver with the values that it is given, which it may overwrite.
class SolverBench {
 public:
  SolverBench(const std::string& name, mbs::MatrixKind kind, const mbs::Pattern& pattern)
      : solver_(mbs::make_solver(name, kind)) {
    analyze(pattern);
  }
  void analyze(const mbs::Pattern& pattern) {
    solver_->analyze(pattern);
    layout_ = solver_->layout();
    values_.resize(layout_.size());
  }
  void place(const Eigen::MatrixXd& a) {
    for (std::size_t k = 0; k < layout_.size(); ++k)
      values_[k] = layout_[k].first < 0 ? 0.0 : a(layout_[k].first, layout_[k].second);
  }
  int factorize_placed() { return solver_->factorize(values_.data()); }
  void solve_in_place(double* b) { solver_->solve(b); }
  int factorize(const Eigen::MatrixXd& a) {
    place(a);
    return factorize_placed();
  }
  std::vector<double> memory() const { return memory_of(*solver_); }
  void recall(const std::vector<double>& memory) { solver_->recall(memory); }
  Eigen::VectorXd solve(Eigen::VectorXd b) {
    solver_->solve(b.data());
    return b;
  }

 private:
  std::unique_ptr<mbs::LinearSolver> solver_;
  mbs::Layout layout_;
  std::vector<double> values_;
};

}  // namespace tandem::test
