// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// A row of what `tandem bench threads` writes.
struct ThreadTime {
  double variables, threads;
  double ns, speed_up;  ///< of a step, for each variable; beside one thread
};

/// Throws Error for a file that is no such table.
std::vector<ThreadTime> read_thread_times(const std::filesystem::path& file);

/// Speed-up over the number of variables, and the time of a step for each variable: a line for each number of
/// threads. Throws Error if there are no rows.
Picture threads_chart(const std::vector<ThreadTime>& times, const std::vector<std::string>& caption);

}  // namespace tandem::charts
