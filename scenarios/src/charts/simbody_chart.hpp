// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "charts/linkage_runs.hpp"
#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// Error against processor time, a row of panels for each start and a column for each number of loops: all
/// runs, and the Pareto front of each family of methods. Throws Error if there are no runs.
Picture simbody_chart(const std::vector<LinkageRun>& runs, const std::vector<std::string>& caption);

}  // namespace tandem::charts
