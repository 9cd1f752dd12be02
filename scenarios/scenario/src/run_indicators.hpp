// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "run_estimate.hpp"
#include "tandem/coordinator/indicators.hpp"

namespace tandem::scenario {

/// Writes FOLDER/indicators.csv, as far as a run has come, to `time` [s]: the end of each window, of each connection the
/// largest defect in it, of each link the energy that was made until then, and the largest estimate in it, if there is one. A cell is empty where nothing was known.
/// Throws Error(input_output) with the path.
void write_indicators(const std::filesystem::path& file, const Indicators& indicators,
                      const Estimate* estimate, double time);

/// To results.json: of connections and links what stands there at the end, and the units of their columns.
void add_figures(const Indicators& indicators, const Estimate* estimate, nlohmann::ordered_json& results);

/// What they say of the whole run, in a line; empty where nothing is known.
std::string told_by(const Indicators& indicators);

}  // namespace tandem::scenario
