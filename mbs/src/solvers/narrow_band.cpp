// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>
#include <array>
#include <cassert>

#include "band_factors.hpp"

namespace tandem::mbs::solvers {
namespace {

/// Of the upper part and of the lower: what elimination does to both is one instruction where the processor
/// has it.
using Pair = Eigen::Array2d;

/// The same in a substitution, where the compiler keeps no array of Eigen's in registers.
struct Ends {
  double upper, lower;
  friend Ends operator*(Ends a, Ends b) { return {a.upper * b.upper, a.lower * b.lower}; }
  friend Ends operator-(Ends a, Ends b) { return {a.upper - b.upper, a.lower - b.lower}; }
};

/// The trailing rows and columns that elimination has reached, lower triangle: [c][r - c]. Loops over one of
/// pairs are unrolled, so that it stands in registers: from pivot to pivot nothing waits for memory.
template <class Real, int size>
using Window = std::array<std::array<Real, size>, size>;

/// A chain is eliminated from both its ends at once, which meet in a block of B columns, W or W + 1: two
/// chains of divisions that don't wait for each other (the twisted factorization; H. A. van der Vorst,
/// Parallel Computing 5 (1987) 45), each operation of both in one instruction. Slots of W + 1 pairs, row by
/// row, each from the diagonal to the left: first what belongs to the upper part and the block, second what
/// belongs to the lower part, mirrored, and what couples the block to it. Slot j becomes [1/d, l_1 .. l_W] of
/// the columns j.
template <int W, int B>
class NarrowBand final : public BandFactors {
 public:
  explicit NarrowBand(int columns) : n_(columns), half_((columns - B) / 2) {}

  Layout layout() const override {
    Layout all;
    for (int row = 0; row < half_ + B; ++row)
      for (int t = 0; t <= W; ++t) {
        const bool here = t <= row, mirrored = here && row - t < half_ && row < half_ + W;
        all.emplace_back(here ? std::pair(row, row - t) : std::pair(-1, -1));
        all.emplace_back(mirrored ? std::pair(n_ - 1 - row, n_ - 1 - row + t) : std::pair(-1, -1));
      }
    return all;
  }

  int factorize(double* a) const override {
    Window<Pair, W> w;
    for (int r = 0; r < W; ++r)
      for (int c = 0; c <= r; ++c) w[c][r - c] = get(a + r * stride, r - c);
    for (int j = 0; j < half_; ++j, a += stride)
      if (!eliminate(w, a)) return above_floor(w[0][0][0], a[0]) ? n_ - 1 - j : j;
    const int bad = eliminate_block(block(w, a), a);
    return bad < 0 ? -1 : half_ + bad;
  }

  void solve(const double* a, double* x) const override {
    double *top = x, *bottom = x + n_ - 1;
    std::array<Ends, W> w;
#pragma GCC unroll 9
    for (int r = 0; r < W; ++r) w[r] = Ends{top[r], r < half_ ? bottom[-r] : 0.0};
    for (int j = 0; j < half_; ++j, a += stride, ++top, --bottom)
      forward(w, a, {top, bottom}, Ends{top[W], j + W < half_ ? bottom[-W] : 0.0});
    solve_block(w, a, top);
    while (top != x) backward(w, a -= stride, {--top, ++bottom});
  }

 private:
  static constexpr std::ptrdiff_t pair = 2, stride = pair * (W + 1);

  static Pair get(const double* slot, std::ptrdiff_t t) { return Eigen::Map<const Pair>(slot + pair * t); }
  static Ends ends(const double* slot, std::ptrdiff_t t) { return {slot[pair * t], slot[pair * t + 1]}; }
  static void put(double* slot, std::ptrdiff_t t, const Pair& value) {
    Eigen::Map<Pair>(slot + pair * t) = value;
  }
  static bool above_floor(double pivot, double diagonal) { return pivot > pivot_floor * diagonal; }

  /// Of the first columns of the window: false if a pivot is not positive. The rows W below enter.
  /// Products come before they are divided, so that a pivot waits for one division, product and difference.
  static bool eliminate(Window<Pair, W>& w, double* slot) {
    const double* const row = slot + W * stride;
    std::array<Pair, W + 1> u;
    for (int r = 0; r < W; ++r) u[r] = w[0][r];
    u[W] = get(row, W);
    if (!above_floor(u[0][0], slot[0]) || !above_floor(u[0][1], slot[1])) return false;
    const Pair inverse = 1.0 / u[0];
    put(slot, 0, inverse);
#pragma GCC unroll 9
    for (int c = 1; c <= W; ++c) {
      put(slot, c, u[c] * inverse);
#pragma GCC unroll 9
      for (int r = c; r <= W; ++r) {
        const Pair before = r == W ? get(row, W - c) : w[c % W][r - c];
        w[c - 1][r - c] = before - u[c] * u[r] * inverse;
      }
    }
    return true;
  }

  /// Where both ends meet, from its first slot on and what they leave there.
  static Window<double, B> block(const Window<Pair, W>& left, const double* slots) {
    Window<double, B> w{};
    for (int c = 0; c < B; ++c) w[c][B - 1 - c] = B > W ? slots[W * stride + pair * (B - 1 - c)] : 0.0;
#pragma GCC unroll 9
    for (int c = 0; c < W; ++c)
#pragma GCC unroll 9
      for (int r = c; r < W; ++r) w[c][r - c] += left[c][r - c][0], w[B - 1 - r][r - c] += left[c][r - c][1];
    return w;
  }

  /// -1, or the column whose pivot is not positive.
  static int eliminate_block(Window<double, B> w, double* slot) {
#pragma GCC unroll 9
    for (int k = 0; k < B; ++k, slot += stride) {
      if (!above_floor(w[k][0], slot[0])) return k;
      const double inverse = 1.0 / w[k][0];
      slot[0] = inverse;
#pragma GCC unroll 9
      for (int c = 1; c < B - k; ++c) {
        slot[pair * c] = w[k][c] * inverse;
#pragma GCC unroll 9
        for (int r = c; r < B - k; ++r) w[k + c][r - c] -= w[k][c] * w[k][r] * inverse;
      }
    }
    return -1;
  }

  struct Places {
    double *top, *bottom;
  };

  static void forward(std::array<Ends, W>& w, const double* slot, const Places& x, Ends next) {
    const Ends y = w[0];
    *x.top = y.upper, *x.bottom = y.lower;
#pragma GCC unroll 9
    for (int r = 1; r <= W; ++r) w[r - 1] = (r == W ? next : w[r % W]) - ends(slot, r) * y;
  }

  /// The nearest term comes last: the next value waits for it alone.
  static void backward(std::array<Ends, W>& w, const double* slot, const Places& x) {
    Ends sum = ends(slot, 0) * Ends{*x.top, *x.bottom};
    for (int r = W; r >= 1; --r) sum = sum - ends(slot, r) * w[r - 1];
    for (int r = W - 1; r >= 1; --r) w[r] = w[r - 1];
    w[0] = sum;
    *x.top = sum.upper, *x.bottom = sum.lower;
  }

  static void solve_block(std::array<Ends, W>& w, const double* slots, double* x) {
    std::array<double, B> y;
    y[B - 1] = B > W ? x[B - 1] : 0.0;
#pragma GCC unroll 9
    for (int r = 0; r < W; ++r) y[r] = w[r].upper;
#pragma GCC unroll 9
    for (int r = 0; r < W; ++r) y[B - 1 - r] += w[r].lower;
#pragma GCC unroll 9
    for (int c = 0; c < B; ++c)
#pragma GCC unroll 9
      for (int r = 1; r < B - c; ++r) y[c + r] -= slots[c * stride + pair * r] * y[c];
#pragma GCC unroll 9
    for (int c = B - 1; c >= 0; --c) {
      y[c] *= slots[c * stride];
#pragma GCC unroll 9
      for (int r = 1; r < B - c; ++r) y[c] -= slots[c * stride + pair * r] * y[c + r];
      x[c] = y[c];
    }
#pragma GCC unroll 9
    for (int r = 0; r < W; ++r) w[r] = Ends{y[r], y[B - 1 - r]};
  }

  int n_, half_;  ///< columns in all, and in each of the parts
};

template <int W>
std::unique_ptr<BandFactors> with_width(int columns) {
  if ((columns - W) % 2 == 0) return std::make_unique<NarrowBand<W, W>>(columns);
  return std::make_unique<NarrowBand<W, W + 1>>(columns);
}

}  // namespace

std::unique_ptr<BandFactors> narrow_band(int columns, int width) {
  assert(width >= 1 && width <= columns);
  switch (width) {
    case 1:
      return with_width<1>(columns);
    case 2:
      return with_width<2>(columns);
    case 3:
      return with_width<3>(columns);
    case 4:
      return with_width<4>(columns);
    case 5:
      return with_width<5>(columns);
    case 6:
      return with_width<6>(columns);
    case 7:
      return with_width<7>(columns);
    case 8:
      return with_width<8>(columns);
    default:
      return nullptr;
  }
}

}  // namespace tandem::mbs::solvers
