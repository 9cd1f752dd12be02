// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// A row of ladder.csv; difference and seconds are NaN where there are none.
struct LadderPoint {
  std::string rung, quantity, unit;
  double difference, tolerance, seconds;
};
/// Throws Error for a file that is no such table.
std::vector<LadderPoint> read_ladder(const std::filesystem::path& file);

/// Difference from the richest against processor time, a panel for each quantity and a point for each rung,
/// numbered from simple to rich, with the tolerance. Rungs without a difference stand in a strip at the top,
/// the richest, of difference 0, at the foot. Throws Error if there are no rows or no times.
Picture ladder_chart(const std::vector<LadderPoint>& points, const std::vector<std::string>& caption);

}  // namespace tandem::charts
