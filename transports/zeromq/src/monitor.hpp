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
  /// From now on the connection that has that descriptor is looked out for. Another one may have the number
  /// as soon as it has ended, and tells nothing of it.
  void watch(int descriptor);
  /// Whether it has ended since.
  bool watched_ended();

 private:
  void hear(std::uint16_t kind, int descriptor);

  zmq::socket_t& socket_;
  zmq::socket_t events_;
  std::set<int> ended_;
  int watched_ = -1;
  bool watched_ended_ = false;
};

}  // namespace tandem::zeromq
