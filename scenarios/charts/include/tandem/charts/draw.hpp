// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/charts/chart.hpp"
#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// A text that stands for a chart.
struct Sheet {
  std::string name, text;
};

/// Pictures and sheets, and in words what they tell.
struct Drawing {
  std::vector<Picture> pictures;
  std::string words;  ///< lines; may be empty
  std::vector<Sheet> sheets = {};
};

/// Draws the charts of tables in a folder. only_table: of charts that name none; empty: they have to. Throws
/// Error for a table that is not there, and for a chart of what no table has, with the place of the chart.
Drawing draw(const Charts& charts, const std::filesystem::path& folder, const std::string& only_table);

}  // namespace tandem::charts
