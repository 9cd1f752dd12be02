// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/stat.h>

#include <string>

namespace tandem {

/// The file of a Unix socket that listens. It goes with its owner, unless another has come in its place.
class SocketFile {
 public:
  SocketFile() = default;  ///< of none
  /// The file is there already.
  explicit SocketFile(std::string path);
  ~SocketFile();
  SocketFile(SocketFile&& other) noexcept;
  SocketFile& operator=(SocketFile&& other) noexcept;

 private:
  std::string path_;
  struct stat there_ {};
};

}  // namespace tandem
