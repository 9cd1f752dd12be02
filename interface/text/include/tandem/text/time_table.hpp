// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tandem::text {

/// Results or data over time: columns with names, `time` first, times that never fall.
struct TimeTable {
  std::filesystem::path file;
  std::vector<double> times;                 ///< [s]
  std::vector<std::string> names;            ///< without time
  std::vector<std::vector<double>> columns;  ///< by name, then by row; NaN for an empty cell

  /// place: a file, CSV or (.npy) of numpy, or a folder that holds results.npy or results.csv. Throws Error
  /// that names the file, and line and column of what is no number, but none of its text: the file may be
  /// none of ours.
  static TimeTable read(const std::filesystem::path& place);
};

}  // namespace tandem::text
