// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <set>

#include "socket.hpp"

namespace tandem::zeromq {

/// Hears which connections of a socket end. One that comes and goes is told by the number of its descriptor.
class Monitor {
 public:
  explicit Monitor(zmq::socket_t& socket);
  ~Monitor();
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

  /// Takes what has come: strangers that come and go are not to pile up.
  void listen();
  /// Whether any has ended.
  bool any_ended();
  /// Whether the one that has that descriptor, or had it last, has ended.
  bool ended(int descriptor);

 private:
  zmq::socket_t& socket_;
  zmq::socket_t events_;
  std::set<int> ended_;
};

}  // namespace tandem::zeromq
