// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

namespace tandem {

/// A folder of its own among the temporary ones, which only this user may enter, and which goes with its
/// owner. One whose process was killed goes when another is made (a minute later, at the earliest).
class TemporaryFolder {
 public:
  /// Throws Error(input_output) if it can't be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_;  ///< held while it is in use, by whom the system knows
};

}  // namespace tandem
