// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace tandem::exported {

/// Writes an archive of files, by their names in it: the same bytes for the same contents. Throws
/// Error(input_output) with the archive's path.
void write_zip(const std::filesystem::path& archive, const std::map<std::string, std::string>& contents);

}  // namespace tandem::exported
