// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tandem::output {

/// Makes a folder and those above it, and keeps it for this process until its owner goes: no other writes
/// results there meanwhile. The lock is the system's (flock) and is on the folder itself: no file stays, and
/// a process that is killed holds nothing. If nothing was written, the folders that were made go again.
///
/// Throws Error(wrong_state) with the folder, and the process that has it where the system tells (Linux);
/// Error(input_output) for a folder that can't be made. Where the file system knows no locks it goes on
/// without, after telling `note` so.
class FolderLock {
 public:
  using Note = std::function<void(const std::string&)>;
  FolderLock(std::filesystem::path folder, const Note& note);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Whether `folder` is the one that is kept.
  bool keeps(const std::filesystem::path& folder) const;

 private:
  bool take(const Note& note);
  void make();
  void remove_made() noexcept;

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> made_;  ///< the outermost first
  int number_ = -1;
};

/// The same of an open file, until it is closed, if it is a regular one; `what` is how the error calls it,
/// "log file 'a'".
void lock_file(int descriptor, const std::string& what);

}  // namespace tandem::output
