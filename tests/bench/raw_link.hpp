// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "bench/answer.hpp"

namespace tandem::bench {

/// Two ends with nothing between them but the system's or ZeroMQ's own calls; the other end, in a thread
/// pinned to places().there, answers so many bytes by so many.
class RawLink {
 public:
  virtual ~RawLink() = default;
  virtual void exchange() = 0;
};

/// `spins`: looks for bytes without a pause, else by calls that wait. Throws Error(input_output).
std::unique_ptr<RawLink> raw_sockets(const std::string& transport, const Sizes& sizes, bool spins);
/// By libzmq at "tcp://..." or "ipc://...", with CURVE keys if asked for; only with ZeroMQ.
std::unique_ptr<RawLink> raw_zeromq(const std::string& address, const Sizes& sizes, bool curve);

}  // namespace tandem::bench
