// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// A run through the flat position: over the angle of the exact motion from upright [degrees], the largest
/// difference in height of a coupler's ends [m] and the size of the error of the crank's angle [rad].
struct Passage {
  std::string formulation, integrator;
  std::vector<double> angle, tilt, angle_error;
};

/// Throws Error for a file that is not what `tandem sweep four_bar` writes.
std::vector<Passage> read_passages(const std::filesystem::path& file);

/// A column for each formulation, a line for each integrator; a cross where a run ends early. Throws Error if
/// there are no rows.
Picture flat_position_chart(const std::vector<Passage>& passages, const std::vector<std::string>& caption);

}  // namespace tandem::charts
