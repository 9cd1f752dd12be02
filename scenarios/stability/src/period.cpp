// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "period.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::stability {

std::optional<Period> common_period(const std::vector<double>& lengths, std::int64_t most) {
  constexpr double tolerance = 1e-12;  // relative: steps are quotients and products of few numbers
  const double largest = *std::max_element(lengths.begin(), lengths.end());
  for (std::int64_t n = 1; n <= most; ++n) {
    Period period{static_cast<double>(n) * largest, {}};
    for (const double h : lengths) {
      const double steps = std::round(period.length / h);
      if (std::abs(period.length / h - steps) > tolerance * steps) break;
      period.steps.push_back(static_cast<std::int64_t>(steps));
    }
    if (period.steps.size() == lengths.size()) return period;
  }
  return {};
}

}  // namespace tandem::stability
