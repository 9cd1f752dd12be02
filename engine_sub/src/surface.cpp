// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cubic.hpp"
#include "tandem/error.hpp"

namespace tandem::engine {

Surface::Surface(const std::string& owner, const Grid& g, Curve::Between between, Curve::Beyond beyond)
    : x_(g.x), between_(between), beyond_(beyond) {
  if (g.z.size() != g.x.size() * g.y.size())
    throw Error(ErrorCode::invalid_argument, fmt::format("{} has {} values; allowed is {} rows of {}", owner,
                                                         g.z.size(), g.x.size(), g.y.size()));
  static_cast<void>(Curve(owner, g.x, g.x, between, beyond));  // checks their order
  for (auto row = g.z.begin(); row != g.z.end(); row += static_cast<std::ptrdiff_t>(g.y.size()))
    rows_.emplace_back(owner, g.y, std::vector(row, row + static_cast<std::ptrdiff_t>(g.y.size())), between,
                       beyond);
}

/// Between the rows `first` and the next. Slopes at the ends of the grid are those of the lines there, as in
/// Curve.
double Surface::across(std::size_t first, double x, double y) const {
  const double h = x_[first + 1] - x_[first], a = rows_[first](y), b = rows_[first + 1](y);
  const double line = (b - a) / h;
  if (between_ == Curve::Between::linear) return a + line * (x - x_[first]);
  std::array<double, 2> slope{line, line};
  if (first > 0) {
    const double k = x_[first] - x_[first - 1];
    slope[0] = harmonic((a - rows_[first - 1](y)) / k, k, line, h);
  }
  if (first + 2 < x_.size()) {
    const double k = x_[first + 2] - x_[first + 1];
    slope[1] = harmonic(line, h, (rows_[first + 2](y) - b) / k, k);
  }
  return hermite({h, a, slope[0], b, slope[1]}, (x - x_[first]) / h);
}

/// The last line goes on beyond the grid; its slope at a cubic's end is that of the straight line there.
double Surface::operator()(double x, double y) const {
  if (std::isnan(x)) return x;
  const bool below = x <= x_.front(), above = x >= x_.back();
  if (!below && !above) {
    const auto k = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin() - 1);
    return across(k, x, y);
  }
  const std::size_t end = below ? 0 : x_.size() - 1, inner = below ? 1 : end - 1;
  const double z = rows_[end](y);
  if (beyond_ == Curve::Beyond::hold) return z;
  return z + (rows_[inner](y) - z) / (x_[inner] - x_[end]) * (x - x_[end]);
}

}  // namespace tandem::engine
