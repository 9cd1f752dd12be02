// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/stat.h>

#include <string>
#include <utility>

#include "socket.hpp"

namespace tandem::zeromq {

/// Whether something is at "ipc://PATH" that must not be replaced: any file but a socket whose server is
/// gone. False for addresses that are no path.
bool taken(const std::string& address);

/// The file of a socket that listens at "ipc://PATH". It goes with its owner, unless another has come in its
/// place. None for an address that is no path.
class IpcFile {
 public:
  IpcFile() = default;
  /// Has a socket listen at an address as bind_to() does. ZeroMQ is given the system's socket: by itself it
  /// would replace whatever is there, and remove, when it closes, whatever is there by then. Precondition:
  /// not taken(). Throws zmq::error_t.
  IpcFile(zmq::socket_t& socket, const std::string& address);
  ~IpcFile();
  IpcFile(IpcFile&& other) noexcept : path_(std::exchange(other.path_, {})), there_(other.there_) {}
  IpcFile& operator=(IpcFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(there_, other.there_);
    return *this;
  }

 private:
  std::string path_;
  struct stat there_ {};
};

}  // namespace tandem::zeromq
