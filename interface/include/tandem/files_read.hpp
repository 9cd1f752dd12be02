// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <set>

namespace tandem {

/// The files that this thread opens as InputFile while one lives; of several the last.
class FilesRead {
 public:
  FilesRead();
  ~FilesRead();
  FilesRead(const FilesRead&) = delete;
  FilesRead& operator=(const FilesRead&) = delete;

  /// Absolute, as they were named otherwise.
  const std::set<std::filesystem::path>& files() const { return files_; }

  /// Of InputFile: notes one.
  static void note(const std::filesystem::path& file);

 private:
  FilesRead* before_;
  std::set<std::filesystem::path> files_;
};

}  // namespace tandem
