// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "tandem/transports/temporary_folder.hpp"

namespace tandem::fmi {

/// Where the file is that a path names, or the archive that holds it; the path, if it is nowhere.
std::filesystem::path outermost(const std::filesystem::path& file);

/// A file that may lie in an archive, or in one within another: "system.ssp/resources/motor.fmu". It is
/// unpacked for as long as this lives.
class PackedFile {
 public:
  /// Throws Error(input_output) for a file that an archive does not hold, and as Archive does. What is nowhere
  /// is left to who reads it.
  explicit PackedFile(const std::filesystem::path& file);

  const std::filesystem::path& on_disk() const { return there_; }

 private:
  std::filesystem::path there_;
  std::unique_ptr<TemporaryFolder> folder_;
};

}  // namespace tandem::fmi
