// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// A row of what `tandem bench four_bar` writes.
struct LinkageTime {
  std::string solver;
  double variables, step, tolerance;  ///< [s], [m]
  double ns;                          ///< of a step, for each variable; NaN if it failed before
};

/// Throws Error for a file that is no such table.
std::vector<LinkageTime> read_linkage_times(const std::filesystem::path& file);

/// The time of a step, and its part for each variable, over the number of variables: a line for each solver,
/// with steps of 1.25 ms and a tolerance of 1e-5 m. Throws Error if there is no such row.
Picture linkage_cost_chart(const std::vector<LinkageTime>& times, const std::vector<std::string>& caption);

}  // namespace tandem::charts
