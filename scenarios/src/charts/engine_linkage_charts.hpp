// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

// The charts of what `tandem sweep engine_linkage` writes. Each reader throws Error for a file that is no
// such table, each chart Error if there are no rows.

/// A row of work.csv; speed_error and seconds are NaN for a run that was unstable.
struct EngineLinkageWork {
  std::string schedule, to_fast, to_slow;
  double step_ratio, speed_error, seconds;  ///< [rad/s], [s]
};
std::vector<EngineLinkageWork> read_engine_linkage_work(const std::filesystem::path& file);
/// Error over the step ratio, a panel for each schedule and a line for each scheme, crosses for unstable
/// ones.
Picture engine_linkage_errors_chart(const std::vector<EngineLinkageWork>& work,
                                    const std::vector<std::string>& caption);
/// Error against the time of a run by scheme and schedule, all step ratios; and the time of the truth [s].
Picture engine_linkage_work_chart(const std::vector<EngineLinkageWork>& work, double truth_seconds,
                                  const std::vector<std::string>& caption);

/// Throttle [deg], speed [rad/s] and torque [N m] of results.csv.
struct EngineLinkageMotion {
  std::vector<Point> throttle, speed, torque;
};
EngineLinkageMotion read_engine_linkage_motion(const std::filesystem::path& file);
Picture engine_linkage_motion_chart(const EngineLinkageMotion& motion,
                                    const std::vector<std::string>& caption);

/// A row of elapsed.csv [s].
struct EngineLinkageElapsed {
  double variables, total, engine, linkage, coordinator;
};
std::vector<EngineLinkageElapsed> read_engine_linkage_elapsed(const std::filesystem::path& file);
/// Elapsed time over the number of variables, with its parts and the 30 s that the motion lasts.
Picture engine_linkage_elapsed_chart(const std::vector<EngineLinkageElapsed>& elapsed,
                                     const std::vector<std::string>& caption);

}  // namespace tandem::charts
