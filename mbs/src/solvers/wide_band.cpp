// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "band_factors.hpp"

namespace tandem::mbs::solvers {
namespace {

/// Panels of four columns are eliminated together, so that each column behind them is read and written once
/// for four. Column j stands at stride j: the diagonal entry, the `width` below it, three zeros, so that the
/// columns of a panel reach equally far, and the diagonal entry once more, which stays.
class WideBand final : public BandFactors {
 public:
  WideBand(int columns, int width) : n_(columns), width_(width), stride_(width + panel + 1) {}

  Layout layout() const override {
    Layout all;
    for (int column = 0; column < n_; ++column) {
      for (int r = 0; r < stride_ - 1; ++r)
        all.emplace_back(r <= width_ && column + r < n_ ? std::pair(column + r, column) : std::pair(-1, -1));
      all.emplace_back(column, column);
    }
    return all;
  }

  int factorize(double* a) const override {
    int j = 0, bad = -1;
    for (; bad < 0 && j + panel <= n_; j += panel) bad = eliminate<panel>(a, j);
    for (; bad < 0 && j < n_; ++j) bad = eliminate<1>(a, j);
    return bad;
  }

  void solve(const double* a, double* x) const override {
    for (int j = 0; j < n_; ++j, a += stride_) {
      const int reach = std::min(width_, n_ - 1 - j);
      for (int r = 1; r <= reach; ++r) x[j + r] -= a[r] * x[j];
    }
    for (int j = n_ - 1; j >= 0; --j) {
      a -= stride_;
      const int reach = std::min(width_, n_ - 1 - j);
      double even = a[0] * x[j], odd = 0.0;  // two sums, as one would wait for each difference
      int r = 1;
      for (; r < reach; r += 2) even -= a[r] * x[j + r], odd += a[r + 1] * x[j + r + 1];
      if (r == reach) even -= a[r] * x[j + r];
      x[j] = even - odd;
    }
  }

 private:
  static constexpr int panel = 4;

  /// Columns j to j + B - 1, and what they change in those behind. -1, or the column whose pivot is not
  /// positive.
  template <int B>
  int eliminate(double* a, int j) const {
    const int rows = width_ + B;  // of the panel, from row j
    double* column[B];            // its entry [r] is that of row j + r
    double inverse[B];
    for (int k = 0; k < B; ++k) column[k] = a + (j + k) * stride_ - k;
    for (int k = 0; k < B; ++k) {
      for (int p = 0; p < k; ++p) subtract<1>({&column[p], &inverse[p]}, k, rows, column[k]);
      if (!(column[k][k] > pivot_floor * column[k][k + stride_ - 1])) return j + k;
      inverse[k] = 1.0 / column[k][k];
    }
    const int last = std::min(rows, n_ - j);
    for (int c = B; c < last; ++c) subtract<B>({column, inverse}, c, rows, a + (j + c) * stride_ - c);
    for (int k = 0; k < B; ++k) {
      column[k][k] = inverse[k];
      for (int r = k + 1; r < rows; ++r) column[k][r] *= inverse[k];
    }
    return -1;
  }

  struct Pivots {
    double* const* column;
    const double* inverse;
  };

  /// target[r] -= sum_k u_k[c] / d_k u_k[r] for rows c to `rows`.
  template <int B>
  static void subtract(const Pivots& pivots, int c, int rows, double* target) {
    const double* u[B];
    double m[B];
    for (int k = 0; k < B; ++k) u[k] = pivots.column[k], m[k] = u[k][c] * pivots.inverse[k];
    for (int r = c; r < rows; ++r) {
      double sum = m[0] * u[0][r];
      for (int k = 1; k < B; ++k) sum += m[k] * u[k][r];
      target[r] -= sum;
    }
  }

  int n_, width_;
  std::ptrdiff_t stride_;
};

}  // namespace

std::unique_ptr<BandFactors> wide_band(int columns, int width) {
  return std::make_unique<WideBand>(columns, width);
}

}  // namespace tandem::mbs::solvers
