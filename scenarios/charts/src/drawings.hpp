// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "table.hpp"
#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// Curves and work. overlay: the second table; null if the chart has none.
Picture draw_points(const Chart& chart, const Charts& charts, const Table& table, const Table* overlay);
/// words: which is best of each column is added to it.
Picture draw_map(const Chart& chart, const Charts& charts, const Table& table, std::string& words);
std::string markdown_table(const Chart& chart, const Charts& charts, const Table& table);
Picture draw_traces(const Chart& chart, const Charts& charts, const Table& table);

}  // namespace tandem::charts
