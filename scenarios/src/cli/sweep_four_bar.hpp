// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

#include "cli/commands.hpp"

namespace tandem::cli {

/// The four-bar linkage through its flat position: four_bar.csv, four_bar_traces.csv and
/// four_bar_conditions.json in the folder. Throws RunFailed if it is interrupted.
void sweep_four_bar(const std::filesystem::path& folder, unsigned threads, const Context& context);

}  // namespace tandem::cli
