// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

// The charts of what `tandem sweep kart` writes. Each reader throws Error for a file that is no such table,
// each chart Error if there are no rows.

/// The runs of a level that traces.csv has: reference, worst and best scheme, each with its columns over time
/// [s]. Columns of quantities that the level has not are left out.
struct KartLevel {
  std::string name;
  struct Run {
    std::string scheme;  ///< "fastest-first, lagrange1, mean"
    std::map<std::string, std::vector<Point>> columns;
  };
  std::map<std::string, Run> runs;  ///< "reference", "worst", "best"
};
/// In the order of the file.
std::vector<KartLevel> read_kart_traces(const std::filesystem::path& file);
/// Throttle, pitch, and what worst and best scheme differ, with the changes of gear marked: Figures 6.12 to
/// 6.15 of the thesis.
Picture kart_pitch_chart(const KartLevel& level, const std::vector<std::string>& caption);
/// Torque, speed, gear, wheel loads and slips of the reference, as far as the level has them.
Picture kart_course_chart(const KartLevel& level, const std::vector<std::string>& caption);

/// A row of work.csv; pitch_error is NaN for a run that failed or was unstable.
struct KartWork {
  std::string level, schedule, to_fast, to_slow;
  double ratio, pitch_error, seconds;  ///< [deg], [s]
};
std::vector<KartWork> read_kart_work(const std::filesystem::path& file);
/// Error against the time of a run: a panel for each level, a line for each scheme, a point for each ratio.
Picture kart_work_chart(const std::vector<KartWork>& work, const std::vector<std::string>& caption);

}  // namespace tandem::charts
