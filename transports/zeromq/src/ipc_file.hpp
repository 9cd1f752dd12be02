// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>

namespace tandem::zeromq {

/// Whether something is at "ipc://PATH" that ZeroMQ must not replace, as its bind() would: any file but a
/// socket whose server is gone. False for addresses that are no path.
bool taken(const std::string& address);

/// The file of a socket that listens at "ipc://PATH": it goes with its owner. (ZeroMQ removes it too, but in
/// a thread of its own that does not outlive the process.) None for an address that is no path.
class IpcFile {
 public:
  explicit IpcFile(const std::string& address = "");
  ~IpcFile();
  IpcFile(IpcFile&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  IpcFile& operator=(IpcFile&& other) noexcept {
    std::swap(path_, other.path_);
    return *this;
  }

 private:
  std::string path_;
};

}  // namespace tandem::zeromq
