// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/engine/curve.hpp"

namespace tandem::engine {

/// A function of two variables through the points of a grid: bilinear, or along each axis the monotone cubic
/// of Curve. The cubic goes first along y in the four rows around a point, then along x through what they
/// gave. Once differentiable, and no overshoot along a line of the grid.
class Surface {
 public:
  struct Grid {
    std::vector<double> x, y;  ///< ascending, two or more of each
    std::vector<double> z;     ///< a row over y for each x, one after the other
  };
  /// Throws Error that names `owner` and what is wrong.
  Surface(const std::string& owner, const Grid& grid, Curve::Between between, Curve::Beyond beyond);

  double operator()(double x, double y) const;

 private:
  double across(std::size_t first, double x, double y) const;
  std::vector<double> x_;
  std::vector<Curve> rows_;
  Curve::Between between_;
  Curve::Beyond beyond_;
};

}  // namespace tandem::engine
