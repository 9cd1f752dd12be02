// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/transports/socket_file.hpp"

#include <unistd.h>

#include <utility>

namespace tandem {

SocketFile::SocketFile(std::string path) : path_(std::move(path)) { ::lstat(path_.c_str(), &there_); }

SocketFile::~SocketFile() {
  struct stat now {};
  if (path_.empty() || ::lstat(path_.c_str(), &now) != 0) return;
  if (now.st_ino == there_.st_ino && now.st_dev == there_.st_dev) ::unlink(path_.c_str());
}

SocketFile::SocketFile(SocketFile&& other) noexcept
    : path_(std::exchange(other.path_, {})), there_(other.there_) {}

SocketFile& SocketFile::operator=(SocketFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(there_, other.there_);
  return *this;
}

}  // namespace tandem
