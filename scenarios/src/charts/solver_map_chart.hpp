// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// A row of what `tandem bench solvers` writes.
struct SolverTime {
  std::string kind, placement, solver;
  double variables, filling;
  double over_smooth, over_rough;  ///< its time over that of the best; NaN: out of the question
};

/// Throws Error for a file that is no such table.
std::vector<SolverTime> read_solver_times(const std::filesystem::path& file);

/// The best solver at each size and filling, by its letter, one panel for each kind of matrix, placement of
/// its entries, and whether pivots may be used again; shaded where `auto` takes more time, framed where the
/// thesis' rule takes over 1.5 times as long.
Picture solver_map_chart(const std::vector<SolverTime>& times, const std::vector<std::string>& caption);

}  // namespace tandem::charts
