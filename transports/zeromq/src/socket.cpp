// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "socket.hpp"

#include <algorithm>
#include <cerrno>

#include "tandem/error.hpp"
#include "tandem/wire/frame.hpp"

namespace tandem::zeromq {
namespace {

/// Messages of a peer that are kept, each way. The protocol needs one; with one libzmq 4.3.4 ends no
/// handshake of CURVE.
constexpr int most_waiting = 2;

}  // namespace

zmq::context_t& context() {
  static auto* the_context = new zmq::context_t(1);
  return *the_context;
}

void fail(const std::string& what, const std::string& address, const zmq::error_t& error) {
  throw Error(ErrorCode::input_output, what + " zmq:" + address + ": " + error.what());
}

void secure(zmq::socket_t& socket, const ZmqSettings& settings, const std::string& domain) {
  socket.set(zmq::sockopt::linger, 200);
  socket.set(zmq::sockopt::handshake_ivl, static_cast<int>(std::clamp(1e3 * settings.deadline, 1.0, 1e6)));
  limit_messages(socket, wire::usual_longest + wire::header_size);
  socket.set(zmq::sockopt::sndhwm, most_waiting);
  socket.set(zmq::sockopt::rcvhwm, most_waiting);
  if (settings.keys.secret_key.empty()) return;
  if (!domain.empty()) {
    socket.set(zmq::sockopt::curve_server, true);
    socket.set(zmq::sockopt::zap_domain, domain);
  } else {
    socket.set(zmq::sockopt::curve_serverkey, settings.server_key);
    socket.set(zmq::sockopt::curve_publickey, settings.keys.public_key);
  }
  socket.set(zmq::sockopt::curve_secretkey, settings.keys.secret_key);
}

void limit_messages(zmq::socket_t& socket, std::uint64_t bytes) {
  constexpr std::uint64_t curve_adds = 64;  // bytes, and a few to spare (https://rfc.zeromq.org/spec/26/)
  socket.set(zmq::sockopt::maxmsgsize, static_cast<std::int64_t>(bytes + curve_adds));
}

void bind_to(zmq::socket_t& socket, const std::string& place) {
  socket.set(zmq::sockopt::ipv6, place.starts_with("tcp://["));
  socket.bind(place);
}

void connect_to(zmq::socket_t& socket, const std::string& place) {
  socket.set(zmq::sockopt::ipv6, place.starts_with("tcp://["));
  socket.connect(place);
}

bool readable(zmq::socket_t& socket, int milliseconds) {
  zmq::pollitem_t item{socket.handle(), 0, ZMQ_POLLIN, 0};
  return ::zmq_poll(reinterpret_cast<::zmq_pollitem_t*>(&item), 1, milliseconds) > 0;
}

}  // namespace tandem::zeromq
