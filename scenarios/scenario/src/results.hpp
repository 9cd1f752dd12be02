// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tandem/scenario/run.hpp"

namespace tandem::scenario {

/// What stands beside the CSV: units, how cells were interpolated, the scenario with its overrides, versions,
/// status, notes. It does not depend on the machine's speed.
nlohmann::ordered_json results_of(const Scenario& scenario, const Assembly& assembly,
                                  const Recorder& recorder, const RunEnd& end);

/// Steps, exchanges, seconds and the real-time factor (simulated seconds in a second). Seconds of each
/// subsystem and of the coordinator (with the recording) are there if the run was profiled.
nlohmann::ordered_json machine_figures(const Assembly& assembly, const RunEnd& end,
                                       const RunSettings& settings, double simulated);

/// In place of what was there, whole, also after a power cut. Throws Error(input_output) with the path.
void write_json(const std::filesystem::path& file, const nlohmann::ordered_json& json);

}  // namespace tandem::scenario
