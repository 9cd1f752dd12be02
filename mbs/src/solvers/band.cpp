// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>
#include <vector>

#include "order.hpp"
#include "solvers.hpp"

namespace tandem::mbs::solvers {
namespace {

/// L D L^T of a band matrix in place. Column j stands at (width + 1) j: first the diagonal entry, then the
/// `width` below it; the columns reach past the last row, where they are zero. Diagonal entries become their
/// reciprocals. Width: known to the compiler, or 0. Returns the column whose pivot is not positive, or -1.
template <int Width>
int factorize_band(double* a, int columns, int width) {
  const int w = Width > 0 ? Width : width, stride = w + 1;
  for (int j = 0; j < columns; ++j, a += stride) {
    if (!(a[0] > 0.0)) return j;
    const double inverse = 1.0 / a[0];
    a[0] = inverse;
    for (int c = 1; c <= w; ++c) {
      const double l = a[c] * inverse;
      double* const column = a + c * stride;  // of row j + c
      for (int r = c; r <= w; ++r) column[r - c] -= l * a[r];
    }
    for (int c = 1; c <= w; ++c) a[c] *= inverse;
  }
  return -1;
}

template <int Width>
void solve_band(const double* a, int columns, int width, double* x) {
  const int w = Width > 0 ? Width : width, stride = w + 1;
  for (int j = 0; j < columns; ++j, a += stride)
    for (int r = 1; r <= w; ++r) x[j + r] -= a[r] * x[j];
  a -= stride;
  for (int j = columns - 1; j >= 0; --j, a -= stride) {
    double sum = a[0] * x[j];
    for (int r = 1; r <= w; ++r) sum -= a[r] * x[j + r];
    x[j] = sum;
  }
}

/// Our own solver for chains: a band matrix after an ordering that makes the band narrow (A. George, J. Liu,
/// Computer Solution of Large Sparse Positive Definite Systems, 1981, ch. 4).
class Band final : public LinearSolver {
 public:
  bool lower() const override { return true; }

  void analyze(const Pattern& pattern) override {
    columns_ = pattern.columns();
    place_ = narrow_order(pattern);
    width_ = 1;
    for (const auto& [row, column] : pattern.entries())
      width_ = std::max(width_, std::abs(place_[row] - place_[column]));
    slots_.clear();
    for (const auto& [row, column] : pattern.entries()) {
      const auto [first, last] = std::minmax(place_[row], place_[column]);
      slots_.push_back(first * (width_ + 1) + last - first);
    }
    band_.assign(static_cast<std::size_t>(columns_ + width_) * (width_ + 1), 0.0);
    x_.assign(static_cast<std::size_t>(columns_ + width_), 0.0);
    choose<1, 2, 3, 4, 5, 6, 7>();
  }

  int factorize(const double* values) override {
    std::fill(band_.begin(), band_.end(), 0.0);
    for (std::size_t k = 0; k < slots_.size(); ++k) band_[slots_[k]] = values[k];
    const int bad = factorize_(band_.data(), columns_, width_);
    return bad < 0 ? -1 : static_cast<int>(std::find(place_.begin(), place_.end(), bad) - place_.begin());
  }

  void solve(double* b) override {
    for (int i = 0; i < columns_; ++i) x_[place_[i]] = b[i];
    solve_(band_.data(), columns_, width_, x_.data());
    for (int i = 0; i < columns_; ++i) b[i] = x_[place_[i]];
    std::fill(x_.begin() + columns_, x_.end(), 0.0);
  }

 private:
  template <int... Widths>
  void choose() {
    factorize_ = factorize_band<0>;
    solve_ = solve_band<0>;
    ((width_ == Widths ? (factorize_ = factorize_band<Widths>, solve_ = solve_band<Widths>, 0) : 0), ...);
  }

  int columns_ = 0, width_ = 0;
  std::vector<int> place_;  ///< of each column in the band
  std::vector<int> slots_;  ///< of each value in band_
  std::vector<double> band_, x_;
  int (*factorize_)(double*, int, int) = nullptr;
  void (*solve_)(const double*, int, int, double*) = nullptr;
};

}  // namespace

std::unique_ptr<LinearSolver> band(MatrixKind) { return std::make_unique<Band>(); }

}  // namespace tandem::mbs::solvers
