// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

#include "cli/commands.hpp"

namespace tandem::cli {

/// Torque map, step response and manoeuvre of the models in the folder `diagrams`: torque_map.csv,
/// step_response.csv, manoeuvre.csv and conditions.json in the folder `output`. Throws Error if the diagrams
/// are not there.
void sweep_engine(const std::filesystem::path& diagrams, const std::filesystem::path& output,
                  const Context& context);

}  // namespace tandem::cli
