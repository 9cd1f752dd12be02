// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// A row of what `tandem bench engine_linkage` writes.
struct ElsewhereTime {
  double loops;
  std::string side, transport;  ///< side: the one elsewhere, "engine", "linkage" or "none"
  double seconds;
};

/// Throws Error for a file that is no such table.
std::vector<ElsewhereTime> read_elsewhere_times(const std::filesystem::path& file);

/// Elapsed time of the run, a line for each transport, a panel for each number of loops. Throws Error if
/// there are no rows.
Picture elsewhere_chart(const std::vector<ElsewhereTime>& times, const std::vector<std::string>& caption);

}  // namespace tandem::charts
