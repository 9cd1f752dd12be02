// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tandem::scenario {

/// Results read back from CSV: one header row, `time` first, times that never fall.
struct Table {
  std::filesystem::path file;
  std::vector<double> times;                 ///< [s]
  std::vector<std::string> names;            ///< without time
  std::vector<std::vector<double>> columns;  ///< by name, then by row; NaN for an empty cell

  /// place: a CSV file, or a folder that holds results.csv. Throws Error that names the file, and the line,
  /// column and text of what is no number.
  static Table read(const std::filesystem::path& place);
};

}  // namespace tandem::scenario
