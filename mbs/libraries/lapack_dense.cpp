// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <numeric>
#include <utility>
#include <vector>

#include "blas_threads.hpp"
#include "lapack.hpp"
#include "library_solvers.hpp"

namespace tandem::mbs::solvers {
namespace {

/// All entries of the matrix, column by column; of a symmetric one the upper triangle stays empty.
Layout dense_layout(int n, bool lower) {
  Layout all;
  for (int column = 0; column < n; ++column)
    for (int row = 0; row < n; ++row)
      all.emplace_back(lower && row < column ? std::pair(-1, -1) : std::pair(row, column));
  return all;
}

class Dense : public LinearSolver {
 public:
  void analyze(const Pattern& pattern) override { n_ = pattern.columns(); }

 protected:
  int n_ = 0;
  double* a_ = nullptr;
};

class DenseCholesky final : public Dense {
 public:
  Layout layout() const override { return dense_layout(n_, true); }
  int factorize(double* values) override {
    const OneBlasThread one;
    int info = 0;
    dpotrf_("L", &n_, a_ = values, &n_, &info, 1);
    return info - 1;
  }
  void solve(double* b) override {
    const OneBlasThread one;
    int info = 0;
    dpotrs_("L", &n_, &one_right_side, a_, &n_, b, &n_, &info, 1);
  }
};

/// L D L^T with pivots of one or two rows (J. R. Bunch, L. Kaufman, Math. Comp. 31 (1977) 163).
class DenseSymmetric final : public Dense {
 public:
  void analyze(const Pattern& pattern) override {
    Dense::analyze(pattern);
    pivots_.resize(static_cast<std::size_t>(n_));
    work_.resize(static_cast<std::size_t>(n_) * 64);
  }
  Layout layout() const override { return dense_layout(n_, true); }
  int factorize(double* values) override {
    const OneBlasThread one;
    const int size = static_cast<int>(work_.size());
    int info = 0;
    dsytrf_("L", &n_, a_ = values, &n_, pivots_.data(), work_.data(), &size, &info, 1);
    return info == 0 ? -1 : column_of(info - 1);
  }
  void solve(double* b) override {
    const OneBlasThread one;
    int info = 0;
    dsytrs_("L", &n_, &one_right_side, a_, &n_, pivots_.data(), b, &n_, &info, 1);
  }

 private:
  /// Of a place in the factorized matrix, by the interchanges up to it.
  int column_of(int place) const {
    std::vector<int> columns(pivots_.size());
    std::iota(columns.begin(), columns.end(), 0);
    for (int k = 0; k <= place; ++k) {
      if (pivots_[k] > 0) {
        std::swap(columns[k], columns[pivots_[k] - 1]);
      } else {  // a pivot of the rows k and k + 1
        std::swap(columns[k + 1], columns[-pivots_[k] - 1]);
        ++k;
      }
    }
    return columns[place];
  }

  std::vector<int> pivots_;
  std::vector<double> work_;
};

class DenseLu final : public Dense {
 public:
  void analyze(const Pattern& pattern) override {
    Dense::analyze(pattern);
    pivots_.resize(static_cast<std::size_t>(n_));
  }
  Layout layout() const override { return dense_layout(n_, false); }
  int factorize(double* values) override {
    const OneBlasThread one;
    int info = 0;
    dgetrf_(&n_, &n_, a_ = values, &n_, pivots_.data(), &info);
    return info - 1;
  }
  void solve(double* b) override {
    const OneBlasThread one;
    int info = 0;
    dgetrs_("N", &n_, &one_right_side, a_, &n_, pivots_.data(), b, &n_, &info, 1);
  }

 private:
  std::vector<int> pivots_;
};

}  // namespace

std::unique_ptr<LinearSolver> lapack(MatrixKind kind) {
  if (kind == MatrixKind::positive_definite) return std::make_unique<DenseCholesky>();
  return std::make_unique<DenseSymmetric>();
}
std::unique_ptr<LinearSolver> lapack_lu(MatrixKind) { return std::make_unique<DenseLu>(); }

}  // namespace tandem::mbs::solvers
