// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/charts/draw.hpp"

namespace tandem::cli {

/// Columns of any results, laid over each other: the chart `plot`, and plot.csv with plot.json, which it is
/// drawn from, in the folder. Throws Error for results that can't be read or lack a column.
charts::Drawing plotted(const std::vector<std::filesystem::path>& results,
                        const std::vector<std::string>& columns, const std::filesystem::path& folder);

}  // namespace tandem::cli
