// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "ipc_file.hpp"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace tandem::zeromq {
namespace {

/// Of "ipc://PATH"; "" of other addresses, "ipc://@NAME" among them, which has no file.
std::string path_of(const std::string& address) {
  return address.starts_with("ipc://") && !address.starts_with("ipc://@") ? address.substr(6) : "";
}

bool refuses(const std::string& path) {
  sockaddr_un place{};
  if (path.size() >= sizeof place.sun_path) return false;
  place.sun_family = AF_UNIX;
  std::memcpy(place.sun_path, path.data(), path.size());
  const int probe = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (probe < 0) return false;
  const bool refused =
      ::connect(probe, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0 && errno == ECONNREFUSED;
  ::close(probe);
  return refused;
}

}  // namespace

bool taken(const std::string& address) {
  const std::string path = path_of(address);
  struct stat status {};
  if (path.empty() || ::lstat(path.c_str(), &status) != 0) return false;
  return !S_ISSOCK(status.st_mode) || !refuses(path);
}

IpcFile::IpcFile(const std::string& address) : path_(path_of(address)) {}

IpcFile::~IpcFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

}  // namespace tandem::zeromq
