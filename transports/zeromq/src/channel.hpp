// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <string>

#include "ipc_file.hpp"
#include "monitor.hpp"

namespace tandem::zeromq {

/// The frames of one session.
class ZmqChannel : public wire::Channel {
 public:
  /// Over a socket with one peer, a client's.
  ZmqChannel(zmq::socket_t socket, std::string peer);
  ZmqChannel(const ZmqChannel&) = delete;
  ZmqChannel& operator=(const ZmqChannel&) = delete;

  void send(std::span<const std::byte> frame, wire::Deadline deadline) override;
  std::span<const std::byte> receive(wire::Deadline deadline) override;
  void forget() override;
  bool wait(wire::Deadline deadline) override;
  void close() noexcept override { closed_ = true; }
  const std::string& peer() const override { return peer_; }

 protected:
  /// Sends the frame; false if there was no room for a while.
  virtual bool put(zmq::const_buffer frame);
  /// Takes the frame into message_; false if there is none now, or none by the time-out of a call that waits.
  virtual bool take(bool waits);
  virtual bool ended() { return monitor_.any_ended(); }
  bool take_part(zmq::message_t& part, bool waits);

  zmq::socket_t socket_;
  Monitor monitor_;
  zmq::message_t message_;

 private:
  bool doze(wire::Deadline deadline);
  bool lost();

  std::string peer_;
  int timeout_ = -1;    ///< of a receiving call, as the socket knows it [ms]
  bool there_ = false;  ///< message_ has been waited for and not yet given out
  bool lost_ = false;   ///< the peer is gone
  std::atomic<bool> closed_ = false;
};

/// Payload that a server takes and gives [bytes]. libzmq keeps messages each way, two in its queue and one
/// that is on its way, of a peer that asks on without reading: these and the server's own two stay within the
/// memory of a session.
constexpr std::uint64_t longest_served = std::uint64_t{1} << 24;

/// The serving end: a ROUTER with one peer. Others may connect; what they say and that they leave counts for
/// nothing.
class ServedZmqChannel final : public ZmqChannel {
 public:
  /// token: how the peer calls itself; if it is empty, the peer is who says something first. place, file:
  /// where the socket listens.
  ServedZmqChannel(zmq::socket_t socket, std::string token, const std::string& place, SocketFile file);
  std::uint64_t longest() const override { return longest_served; }

 private:
  bool put(zmq::const_buffer frame) override;
  bool take(bool waits) override;
  bool ended() override { return guest_is_in_ && monitor_.watched_ended(); }
  void let_in();

  std::string guest_;
  bool guest_is_in_ = false;
  SocketFile file_;
};

}  // namespace tandem::zeromq
