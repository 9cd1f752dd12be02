// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

#include "tandem/charts/chart.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::cli {

/// The charts of a study, of a scenario that has none, or of a file that holds charts alone.
struct ChartFile {
  charts::Charts charts;
  std::string only_table;         ///< empty: there are several
  std::filesystem::path results;  ///< the folder of tables, unless another is given
};

/// Of what `tandem ladder` writes, wherever that is.
ChartFile charts_of_ladder();

/// Throws Error with the place of what is wrong, and for a file without charts.
ChartFile read_chart_file(const std::filesystem::path& file, const Builtins& builtins);

}  // namespace tandem::cli
