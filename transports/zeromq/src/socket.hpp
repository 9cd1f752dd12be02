// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <string>
#include <zmq.hpp>

#include "ipc_file.hpp"
#include "tandem/zeromq/zeromq.hpp"

namespace tandem::zeromq {

/// The one of this process, so that inproc:// addresses meet. It is never taken down: a socket that somebody
/// still holds would keep the program from its end.
zmq::context_t& context();

/// Throws Error(input_output) with the address.
[[noreturn]] void fail(const std::string& what, const std::string& address, const zmq::error_t& error);

/// Sets keys, and limits of time and memory; before bind or connect.
void secure(zmq::socket_t& socket, const ZmqSettings& settings, bool server);
/// At what to_open() gives; IPv6 where that is a number of it.
void bind_to(zmq::socket_t& socket, const std::string& place);
void connect_to(zmq::socket_t& socket, const std::string& place);

/// Waits up to so many milliseconds; a signal ends the wait too.
bool readable(zmq::socket_t& socket, int milliseconds);

/// The frames of one session, over a socket with one peer.
class ZmqChannel final : public wire::Channel {
 public:
  /// file: of a socket that listens.
  ZmqChannel(zmq::socket_t socket, std::string peer, IpcFile file = IpcFile());
  ~ZmqChannel() override;
  ZmqChannel(const ZmqChannel&) = delete;
  ZmqChannel& operator=(const ZmqChannel&) = delete;
  void connect(const std::string& place) { connect_to(socket_, place); }

  void send(std::span<const std::byte> frame, wire::Deadline deadline) override;
  std::span<const std::byte> receive(wire::Deadline deadline) override;
  bool wait(wire::Deadline deadline) override;
  void close() noexcept override { closed_ = true; }
  const std::string& peer() const override { return peer_; }

 private:
  bool look();
  bool doze(wire::Deadline deadline);
  bool heard_of_end();
  bool lost();

  zmq::socket_t socket_, monitor_;
  IpcFile file_;
  std::string peer_;
  int timeout_ = -1;  ///< of a receiving call, as the socket knows it [ms]
  zmq::message_t message_;
  bool there_ = false;  ///< message_ has been waited for and not yet given out
  bool lost_ = false;   ///< the peer is gone
  std::atomic<bool> closed_ = false;
};

}  // namespace tandem::zeromq
