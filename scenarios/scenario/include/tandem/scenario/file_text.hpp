// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tandem::scenario {

/// Whether a file is called as a system of the standard SSP is: *.ssp, *.ssd.
bool is_system(const std::filesystem::path& file);

/// A scenario file, or a system in the language of scenarios.
struct FileText {
  std::string text;
  std::vector<int> lines = {};            ///< see text::Document
  std::vector<std::string> remarks = {};  ///< what a user should know of a system
};

/// Throws Error for a file that can't be read, for a system that is not valid, and for any where the build has
/// no FMUs.
FileText file_text(const std::filesystem::path& file);

/// The bytes of a source's file, which may lie in an archive.
std::string source_contents(const std::filesystem::path& file);

}  // namespace tandem::scenario
