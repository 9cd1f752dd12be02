// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace tandem::output {

/// Writes a file, in place of an earlier one. Throws Error(input_output) with path and reason, as of a FIFO;
/// then none is there.
void write_text(const std::filesystem::path& file, const std::string& text);

/// The same by way of FILE.part, which is made anew and renamed when it is complete: never half a file. What
/// is no regular file is not replaced. After an error there is no FILE.part.
void replace_text(const std::filesystem::path& file, const std::string& text);

/// The same on the disk: after it the file is the new one even if the power fails, or else still the old one.
void replace_durably(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// FILE.part, and what is left of one by a process that was killed goes.
std::filesystem::path part_of(const std::filesystem::path& file);
void remove_part(const std::filesystem::path& file) noexcept;

/// Puts what a file holds on the disk. Throws as above.
void sync(const std::filesystem::path& file);

/// Makes a folder and those above it. Throws Error(input_output) with path and reason.
void make_folder(const std::filesystem::path& folder);

/// Throws the Error that make_folder would, or the first file in it; makes nothing.
void check_folder(const std::filesystem::path& folder);

}  // namespace tandem::output
