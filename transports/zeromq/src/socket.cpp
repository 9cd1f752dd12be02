// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "socket.hpp"

#include <algorithm>
#include <cerrno>

#include "tandem/error.hpp"
#include "tandem/wire/frame.hpp"

namespace tandem::zeromq {
namespace {

using Clock = std::chrono::steady_clock;

int milliseconds_to(wire::Deadline deadline, int most) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<long long>(left, 0, most));
}

constexpr int most_waiting = 4;  // messages of a peer that are kept, each way; the protocol needs one
constexpr int slice = 20;        // ms: how often whoever waits looks whether the connection has ended

zmq::socket_t watch(zmq::socket_t& socket) {
  static std::atomic<unsigned> count = 0;
  const std::string name = "inproc://tandem-monitor-" + std::to_string(++count);
  ::zmq_socket_monitor(socket.handle(), name.c_str(), ZMQ_EVENT_DISCONNECTED);
  zmq::socket_t monitor(context(), zmq::socket_type::pair);
  monitor.set(zmq::sockopt::linger, 0);
  monitor.connect(name);
  return monitor;
}

}  // namespace

zmq::context_t& context() {
  static auto* the_context = new zmq::context_t(1);
  return *the_context;
}

void fail(const std::string& what, const std::string& address, const zmq::error_t& error) {
  throw Error(ErrorCode::input_output, what + " zmq:" + address + ": " + error.what());
}

void secure(zmq::socket_t& socket, const ZmqSettings& settings, bool server) {
  socket.set(zmq::sockopt::linger, 200);
  socket.set(zmq::sockopt::handshake_ivl, static_cast<int>(std::clamp(1e3 * settings.deadline, 1.0, 1e6)));
  socket.set(zmq::sockopt::maxmsgsize, static_cast<std::int64_t>(wire::usual_longest + wire::header_size));
  socket.set(zmq::sockopt::sndhwm, most_waiting);
  socket.set(zmq::sockopt::rcvhwm, most_waiting);
  if (settings.keys.secret_key.empty()) return;
  if (server) {
    socket.set(zmq::sockopt::curve_server, true);
    socket.set(zmq::sockopt::zap_domain, "tandem");
  } else {
    socket.set(zmq::sockopt::curve_serverkey, settings.server_key);
    socket.set(zmq::sockopt::curve_publickey, settings.keys.public_key);
  }
  socket.set(zmq::sockopt::curve_secretkey, settings.keys.secret_key);
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

ZmqChannel::ZmqChannel(zmq::socket_t socket, std::string peer, IpcFile file)
    : socket_(std::move(socket)), monitor_(watch(socket_)), file_(std::move(file)), peer_(std::move(peer)) {}

/// ZeroMQ's own thread would wait for ever to tell of an event that nobody listens to any more.
ZmqChannel::~ZmqChannel() { ::zmq_socket_monitor(socket_.handle(), nullptr, 0); }

void ZmqChannel::send(std::span<const std::byte> frame, wire::Deadline deadline) {
  const zmq::const_buffer bytes(frame.data(), frame.size());
  try {
    while (!closed_ && !lost_) {
      if (socket_.send(bytes, zmq::send_flags::dontwait)) return;
      lost_ = heard_of_end();
      zmq::pollitem_t item{socket_.handle(), 0, ZMQ_POLLOUT, 0};
      ::zmq_poll(reinterpret_cast<::zmq_pollitem_t*>(&item), 1, milliseconds_to(deadline, slice));
      if (Clock::now() > deadline)
        throw Error(ErrorCode::input_output, "the peer took no data within the deadline");
    }
  } catch (const zmq::error_t& error) {
    throw Error(ErrorCode::input_output, std::string("the connection broke: ") + error.what());
  }
  throw Error(ErrorCode::input_output, "the connection was closed");
}

bool ZmqChannel::look() { return there_ = socket_.recv(message_, zmq::recv_flags::dontwait).has_value(); }

bool ZmqChannel::heard_of_end() {
  zmq::message_t event;
  return monitor_.recv(event, zmq::recv_flags::dontwait).has_value();
}

/// True once the peer is gone and nothing is left of it.
bool ZmqChannel::lost() {
  lost_ = lost_ || heard_of_end();
  return (lost_ || closed_) && !look();
}

/// Waits in the receiving call itself, which costs half of what zmq_poll does. A signal ends the wait. To
/// look without a pause first, as sockets do, would keep the processor from ZeroMQ's own thread, which has
/// the message.
bool ZmqChannel::doze(wire::Deadline deadline) {
  const int timeout = milliseconds_to(deadline, slice);
  if (timeout != timeout_) socket_.set(zmq::sockopt::rcvtimeo, timeout);
  timeout_ = timeout;
  there_ = ::zmq_msg_recv(message_.handle(), socket_.handle(), 0) >= 0;
  if (!there_ && ::zmq_errno() != EAGAIN && ::zmq_errno() != EINTR) throw zmq::error_t();
  return there_;
}

bool ZmqChannel::wait(wire::Deadline deadline) {
  if (there_) return true;
  try {
    while (!doze(deadline)) {
      if (lost()) return true;
      if (Clock::now() > deadline) return false;
    }
  } catch (const zmq::error_t& error) {
    throw Error(ErrorCode::input_output, std::string("the connection broke: ") + error.what());
  }
  return true;
}

std::span<const std::byte> ZmqChannel::receive(wire::Deadline deadline) {
  if (!wait(deadline)) throw Error(ErrorCode::input_output, "no reply came within the deadline");
  if (!there_) return {};
  there_ = false;
  if (message_.size() == 0) throw Error(ErrorCode::invalid_argument, "the frame has 0 bytes");
  return {message_.data<std::byte>(), message_.size()};
}

}  // namespace tandem::zeromq
