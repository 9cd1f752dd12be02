// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

// The charts of what `tandem sweep engine` writes. Each reader throws Error for a file that is no such table,
// each chart Error if there are no rows.

/// Torque [N m] over speed [rpm] by plate angle [deg].
using TorqueMap = std::map<double, std::vector<Point>>;
TorqueMap read_torque_map(const std::filesystem::path& file);
Picture engine_torque_map_chart(const TorqueMap& map, const TorqueMap& printed,
                                const std::vector<std::string>& caption);

/// Columns over time [s], by their names.
using Courses = std::map<std::string, std::vector<Point>>;
Courses read_engine_step(const std::filesystem::path& file);
/// Speed and what is asked for, plate angle, torque.
Picture engine_step_chart(const Courses& courses, const std::vector<std::string>& caption);

Courses read_manoeuvre(const std::filesystem::path& file);
/// The whole manoeuvre and two of its changes of gear: throttle, ratio and fill, engine speed, torque of the
/// driven shaft, pitch.
Picture engine_gears_chart(const Courses& courses, const std::vector<std::string>& caption);

}  // namespace tandem::charts
