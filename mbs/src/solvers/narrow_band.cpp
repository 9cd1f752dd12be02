// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cassert>

#include "band_factors.hpp"

namespace tandem::mbs::solvers {
namespace {

/// The trailing rows and columns that elimination has reached, W x W, lower triangle: [c][r - c].
template <int W>
using Window = std::array<std::array<double, W>, W>;

/// A chain is eliminated from both its ends at once, which meet in a block of W columns: two chains of
/// divisions that don't wait for each other (the twisted factorization; H. A. van der Vorst, Parallel
/// Computing 5 (1987) 45). Slots of W + 1 values: those of the upper part and the block, row by row, each
/// from the diagonal to the left; then those of the lower part, mirrored, and the block once more, of which
/// they hold nothing but what couples it to the lower part. Slot j becomes [1/d, l_1 .. l_W] of column j.
template <int W>
class NarrowBand final : public BandFactors {
 public:
  explicit NarrowBand(int columns)
      : n_(columns), upper_((columns - W + 1) / 2), lower_(columns - W - upper_) {}

  Layout layout() const override {
    Layout all;
    for (int row = 0; row < upper_ + W; ++row)
      for (int t = 0; t <= W; ++t) all.emplace_back(t <= row ? std::pair(row, row - t) : std::pair(-1, -1));
    for (int row = 0; row < lower_ + W; ++row)
      for (int t = 0; t <= W; ++t)
        all.emplace_back(t <= row && row - t < lower_ ? std::pair(n_ - 1 - row, n_ - 1 - row + t)
                                                      : std::pair(-1, -1));
    return all;
  }

  int factorize(double* a) const override {
    double *up = a, *low = a + (upper_ + W) * stride;
    Window<W> upper = begin(up), lower = begin(low);
    for (int j = 0; j < lower_; ++j, up += stride, low += stride) {
      if (!eliminate(upper, up)) return j;
      if (!eliminate(lower, low)) return n_ - 1 - j;
    }
    if (upper_ > lower_) {
      if (!eliminate(upper, up)) return lower_;
      up += stride;
    }
    for (int c = 0; c < W; ++c)
      for (int r = c; r < W; ++r) upper[c][r - c] += lower[W - 1 - r][r - c];
    const int bad = eliminate_block(upper, up);
    return bad < 0 ? -1 : upper_ + bad;
  }

  void solve(const double* a, double* x) const override {
    const double *up = a, *low = a + (upper_ + W) * stride;
    std::array<double, W> upper, lower;
    for (int r = 0; r < W; ++r) upper[r] = x[r], lower[r] = r < lower_ ? x[n_ - 1 - r] : 0.0;
    double *top = x, *bottom = x + n_ - 1;
    for (int j = 0; j < lower_; ++j, up += stride, low += stride, ++top, --bottom) {
      forward(upper, up, top, top[W]);
      forward(lower, low, bottom, j + W < lower_ ? bottom[-W] : 0.0);
    }
    if (upper_ > lower_) forward(upper, up, top, top[W]), up += stride, ++top;
    for (int c = 0; c < W; ++c) upper[c] += lower[W - 1 - c];
    solve_block(upper, up);
    for (int c = 0; c < W; ++c) top[c] = upper[c], lower[c] = upper[W - 1 - c];
    if (upper_ > lower_) backward(upper, up -= stride, --top);
    while (top != x) {
      backward(upper, up -= stride, --top);
      backward(lower, low -= stride, ++bottom);
    }
  }

 private:
  static constexpr int stride = W + 1;

  static Window<W> begin(const double* slots) {
    Window<W> w{};
    for (int r = 0; r < W; ++r)
      for (int c = 0; c <= r; ++c) w[c][r - c] = slots[r * stride + r - c];
    return w;
  }

  /// Of the first column of the window: false if its pivot is not positive. The row W below enters.
  /// Products come before they are divided, so that a pivot waits for one division, product and difference.
  static bool eliminate(Window<W>& w, double* slot) {
    const double* const row = slot + W * stride;
    std::array<double, W + 1> u;
    for (int r = 0; r < W; ++r) u[r] = w[0][r];
    u[W] = row[W];
    if (!(u[0] > pivot_floor * slot[0])) return false;
    const double inverse = 1.0 / u[0];
    slot[0] = inverse;
    for (int c = 1; c <= W; ++c) {
      slot[c] = u[c] * inverse;
      for (int r = c; r <= W; ++r) {
        const double before = r == W ? row[W - c] : w[c % W][r - c];
        w[c - 1][r - c] = before - u[c] * u[r] * inverse;
      }
    }
    return true;
  }

  /// The block where both ends meet: -1, or the column whose pivot is not positive.
  static int eliminate_block(Window<W>& w, double* slot) {
    for (int k = 0; k < W; ++k, slot += stride) {
      if (!(w[k][0] > pivot_floor * slot[0])) return k;
      const double inverse = 1.0 / w[k][0];
      slot[0] = inverse;
      for (int c = 1; c < W - k; ++c) {
        slot[c] = w[k][c] * inverse;
        for (int r = c; r < W - k; ++r) w[k + c][r - c] -= w[k][c] * w[k][r] * inverse;
      }
    }
    return -1;
  }

  static void forward(std::array<double, W>& w, const double* slot, double* x, double next) {
    const double y = *x = w[0];
    for (int r = 1; r <= W; ++r) w[r - 1] = (r == W ? next : w[r % W]) - slot[r] * y;
  }

  /// The nearest term comes last: the next value waits for it alone.
  static void backward(std::array<double, W>& w, const double* slot, double* x) {
    double sum = slot[0] * *x;
    for (int r = W; r >= 1; --r) sum -= slot[r] * w[r - 1];
    for (int r = W - 1; r >= 1; --r) w[r] = w[r - 1];
    *x = w[0] = sum;
  }

  static void solve_block(std::array<double, W>& x, const double* slots) {
    for (int c = 0; c < W; ++c)
      for (int r = 1; r < W - c; ++r) x[c + r] -= slots[c * stride + r] * x[c];
    for (int c = W - 1; c >= 0; --c) {
      x[c] *= slots[c * stride];
      for (int r = 1; r < W - c; ++r) x[c] -= slots[c * stride + r] * x[c + r];
    }
  }

  int n_, upper_, lower_;  ///< columns in all, and in the parts above and below the block
};

}  // namespace

std::unique_ptr<BandFactors> narrow_band(int columns, int width) {
  assert(width >= 1 && width <= columns);
  switch (width) {
    case 1:
      return std::make_unique<NarrowBand<1>>(columns);
    case 2:
      return std::make_unique<NarrowBand<2>>(columns);
    case 3:
      return std::make_unique<NarrowBand<3>>(columns);
    case 4:
      return std::make_unique<NarrowBand<4>>(columns);
    case 5:
      return std::make_unique<NarrowBand<5>>(columns);
    case 6:
      return std::make_unique<NarrowBand<6>>(columns);
    case 7:
      return std::make_unique<NarrowBand<7>>(columns);
    case 8:
      return std::make_unique<NarrowBand<8>>(columns);
    default:
      return nullptr;
  }
}

}  // namespace tandem::mbs::solvers
