// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>

#include "stream.hpp"

namespace tandem::tcp {

/// The one that sockets are made with; nothing runs in it.
boost::asio::io_context& context();

using Socket = boost::asio::generic::stream_protocol::socket;

/// True when the socket may be read or written (events: POLLIN, POLLOUT), false at the deadline; a signal
/// does not end the wait. `interruptible`: it does, with false.
bool wait_for(int socket, short events, wire::Deadline deadline, bool interruptible = false);

/// A socket in plain text.
class SocketStream final : public Stream {
 public:
  /// Takes the descriptor out of Asio, which would have each arrival of bytes told to an event queue of the
  /// system that nobody waits for: 0.25 µs of a round trip.
  SocketStream(Socket socket, double spin) : descriptor_(socket.release()), spin_(spin) {}
  ~SocketStream() override;
  SocketStream(const SocketStream&) = delete;
  SocketStream& operator=(const SocketStream&) = delete;

  std::optional<std::size_t> read(std::span<std::byte> to, wire::Deadline deadline) override;
  void write(std::span<const std::byte> bytes, wire::Deadline deadline) override;
  void shut_down() noexcept override;

 private:
  std::optional<std::size_t> receive(std::span<std::byte> to, int flags);
  void set_timeout(wire::Deadline deadline);

  int descriptor_;
  double spin_;           ///< [s]
  double timeout_ = 0.0;  ///< as the system knows it [s]
};

}  // namespace tandem::tcp
