// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tandem::charts {

/// Runs a program (the first word, found through PATH) with these arguments in that folder, without a shell,
/// and waits for its end. Throws Error if it can't be started, naming `where` it comes from, or if it ends
/// with another status than 0, with the last line that it wrote to standard error.
void run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                 const std::string& where);

}  // namespace tandem::charts
