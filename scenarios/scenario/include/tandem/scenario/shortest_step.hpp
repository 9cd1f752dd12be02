// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

namespace tandem::scenario {

/// A step that is the difference of two times, from `start` on [s]: of the numbers that are the same but for their rounding
/// the shortest.
inline double shortest_step(double difference, double start) {
  const double most = 4.0 * std::numeric_limits<double>::epsilon() * (std::abs(start) + difference);
  for (int digits = 1; digits < 17; ++digits)
    if (const double shorter = std::stod(fmt::format("{:.{}e}", difference, digits - 1));
        std::abs(shorter - difference) <= most)
      return shorter;
  return difference;
}

}  // namespace tandem::scenario
