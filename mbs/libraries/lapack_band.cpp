// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vector>

#include "blas_threads.hpp"
#include "lapack.hpp"
#include "solvers/order.hpp"
#include "library_solvers.hpp"

namespace tandem::mbs::solvers {
namespace {

/// LAPACK's band matrices in an order that makes the band narrow: Cholesky's factorization of a positive
/// definite matrix, else LU with row interchanges.
class LapackBand final : public LinearSolver {
 public:
  explicit LapackBand(MatrixKind kind) : definite_(kind == MatrixKind::positive_definite) {}

  void analyze(const Pattern& pattern) override {
    const auto place = narrow_order(pattern);
    n_ = pattern.columns();
    width_ = band_width(pattern, place);
    height_ = definite_ ? width_ + 1 : 3 * width_ + 1;
    order_.resize(place.size());
    for (int column = 0; column < n_; ++column) order_[place[column]] = column;
    pivots_.resize(order_.size());
    x_.resize(order_.size());
  }

  /// Column by column; the diagonal stands in its first row, or in row 2 width of the general form, whose
  /// first `width` rows are for fill.
  Layout layout() const override {
    Layout all;
    const int diagonal = definite_ ? 0 : 2 * width_;
    for (int column = 0; column < n_; ++column)
      for (int k = 0; k < height_; ++k) {
        const int row = column + k - diagonal;
        const bool there = k >= diagonal - width_ && row >= 0 && row < n_;
        all.emplace_back(there ? std::pair(order_[row], order_[column]) : std::pair(-1, -1));
      }
    return all;
  }

  int factorize(double* values) override {
    const OneBlasThread one;
    int info = 0;
    a_ = values;
    if (definite_)
      dpbtrf_("L", &n_, &width_, a_, &height_, &info, 1);
    else
      dgbtrf_(&n_, &n_, &width_, &width_, a_, &height_, pivots_.data(), &info);
    return info == 0 ? -1 : order_[info - 1];
  }

  void solve(double* b) override {
    const OneBlasThread one;
    int info = 0;
    for (int k = 0; k < n_; ++k) x_[k] = b[order_[k]];
    if (definite_)
      dpbtrs_("L", &n_, &width_, &one_right_side, a_, &height_, x_.data(), &n_, &info, 1);
    else
      dgbtrs_("N", &n_, &width_, &width_, &one_right_side, a_, &height_, pivots_.data(), x_.data(), &n_,
              &info, 1);
    for (int k = 0; k < n_; ++k) b[order_[k]] = x_[k];
  }

 private:
  bool definite_;
  int n_ = 0, width_ = 0, height_ = 0;
  std::vector<int> order_, pivots_;  ///< by place the column; row interchanges
  double* a_ = nullptr;
  std::vector<double> x_;
};

}  // namespace

std::unique_ptr<LinearSolver> lapack_band(MatrixKind kind) { return std::make_unique<LapackBand>(kind); }

}  // namespace tandem::mbs::solvers
