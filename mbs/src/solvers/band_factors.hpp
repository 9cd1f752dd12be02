// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "tandem/mbs/sparse/linear_solver.hpp"

namespace tandem::mbs::solvers {

/// A pivot below this part of its diagonal entry is rounding: the matrix is singular to working precision.
inline constexpr double pivot_floor = 1e-15;

/// L D L^T of a symmetric positive definite band matrix, in place. The layout is that of LinearSolver.
class BandFactors {
 public:
  virtual ~BandFactors() = default;
  virtual Layout layout() const = 0;
  virtual int factorize(double* a) const = 0;
  /// a: what factorize() left.
  virtual void solve(const double* a, double* x) const = 0;
};

/// Widths up to 8, known to the compiler. Precondition: width < columns, or both are 1.
std::unique_ptr<BandFactors> narrow_band(int columns, int width);
/// Any width.
std::unique_ptr<BandFactors> wide_band(int columns, int width);

}  // namespace tandem::mbs::solvers
