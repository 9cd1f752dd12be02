// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// A row of what `tandem bench transports` writes.
struct TransportTime {
  std::string transport, wait;
  double signals, samples;
  double median, p99, raw_median;  ///< of an exchange [microseconds]
};

/// Throws Error for a file that is no such table.
std::vector<TransportTime> read_transport_times(const std::filesystem::path& file);

/// Round trips of an advance with 4 signals, a line for each transport and way to wait, a panel for each
/// number of samples returned: median, 99th percentile, and the median without tandem. Throws Error if there
/// are none.
Picture transports_chart(const std::vector<TransportTime>& times, const std::vector<std::string>& caption);

}  // namespace tandem::charts
