// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

#include "cli/commands.hpp"

namespace tandem::cli {

/// Every scheme on the split pendulum, and the ratio of masses that each stands: schemes.csv, limits.csv and
/// conditions.json in that folder. Throws RunFailed if it is interrupted.
void sweep_split_pendulum(const std::filesystem::path& output, unsigned threads, const Context& context);

}  // namespace tandem::cli
