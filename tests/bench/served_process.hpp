// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/types.h>

#include <string>

#include "bench/answer_link.hpp"

namespace tandem::bench {

/// A source in another process: `tandem serve SOURCE`, this same program, at an address of one of
/// linked_transports(), for one session. It ends with its owner.
class ServedProcess {
 public:
  /// folder: has the socket's file, and the keys of "tls" and "zmq:curve".
  ServedProcess(const std::string& source, const std::string& transport, const LinkFolder& folder);
  ~ServedProcess();
  ServedProcess(const ServedProcess&) = delete;
  ServedProcess& operator=(const ServedProcess&) = delete;
  /// What opens it, with a deadline, and with keys where they are needed; more parameters may follow a `&`.
  const std::string& uri() const { return uri_; }

 private:
  std::string uri_;
  pid_t process_ = -1;
};

}  // namespace tandem::bench
