// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace tandem::output {

/// Writes a file, in place of an earlier one. Throws Error(input_output) with path and reason.
void write_text(const std::filesystem::path& file, const std::string& text);

/// The same by way of FILE.part, which is renamed when it is complete: never half a file.
void replace_text(const std::filesystem::path& file, const std::string& text);

/// Makes a folder and those above it. Throws Error(input_output) with path and reason.
void make_folder(const std::filesystem::path& folder);

/// Throws the Error that make_folder would, or the first file in it; makes nothing.
void check_folder(const std::filesystem::path& folder);

}  // namespace tandem::output
