// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "channel.hpp"

#include <algorithm>
#include <cerrno>
#include <thread>

#include "tandem/error.hpp"

namespace tandem::zeromq {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int slice = 20;  // ms: how often whoever waits looks whether the connection has ended

int milliseconds_to(wire::Deadline deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<long long>(left, 0, slice));
}

[[noreturn]] void broke(const zmq::error_t& error) {
  throw Error(ErrorCode::input_output, std::string("the connection broke: ") + error.what());
}

}  // namespace

ZmqChannel::ZmqChannel(zmq::socket_t socket, std::string peer)
    : socket_(std::move(socket)), monitor_(socket_), peer_(std::move(peer)) {
  socket_.set(zmq::sockopt::sndtimeo, slice);
}

bool ZmqChannel::put(zmq::const_buffer frame) {
  return socket_.send(frame, zmq::send_flags::none).has_value();
}

void ZmqChannel::send(std::span<const std::byte> frame, wire::Deadline deadline) {
  const zmq::const_buffer bytes(frame.data(), frame.size());
  try {
    while (!closed_ && !lost_) {
      if (put(bytes)) return;
      lost_ = ended();
      if (Clock::now() > deadline)
        throw Error(ErrorCode::input_output, "the peer took no data within the deadline");
    }
  } catch (const zmq::error_t& error) {
    broke(error);
  }
  throw Error(ErrorCode::input_output, "the connection was closed");
}

bool ZmqChannel::take_part(zmq::message_t& part, bool waits) {
  if (::zmq_msg_recv(part.handle(), socket_.handle(), waits ? 0 : ZMQ_DONTWAIT) >= 0) return true;
  if (::zmq_errno() != EAGAIN && ::zmq_errno() != EINTR) throw zmq::error_t();
  return false;
}

bool ZmqChannel::take(bool waits) { return take_part(message_, waits); }

/// True once the peer is gone and nothing is left of it.
bool ZmqChannel::lost() {
  lost_ = lost_ || ended();
  return (lost_ || closed_) && !(there_ = take(false));
}

/// Waits in the receiving call itself, which costs half of what zmq_poll does. A signal ends the wait. To
/// look without a pause first, as sockets do, would keep the processor from ZeroMQ's own thread, which has
/// the message.
bool ZmqChannel::doze(wire::Deadline deadline) {
  const int timeout = milliseconds_to(deadline);
  if (timeout != timeout_) socket_.set(zmq::sockopt::rcvtimeo, timeout);
  timeout_ = timeout;
  return there_ = take(true);
}

bool ZmqChannel::wait(wire::Deadline deadline) {
  if (there_) return true;
  monitor_.listen();
  try {
    while (!doze(deadline)) {
      if (lost()) return true;
      if (Clock::now() > deadline) return false;
    }
  } catch (const zmq::error_t& error) {
    broke(error);
  }
  return true;
}

std::span<const std::byte> ZmqChannel::receive(wire::Deadline deadline) {
  if (!wait(deadline)) throw Error(ErrorCode::input_output, "no reply came within the deadline");
  if (!there_) return {};
  there_ = false;
  if (message_.more()) throw Error(ErrorCode::invalid_argument, "the frame has several parts");
  if (message_.size() == 0) throw Error(ErrorCode::invalid_argument, "the frame has 0 bytes");
  return {message_.data<std::byte>(), message_.size()};
}

void ZmqChannel::forget() {
  if (!there_) message_.rebuild();
}

ServedZmqChannel::ServedZmqChannel(zmq::socket_t socket, std::string token, const std::string& place,
                                   SocketFile file)
    : ZmqChannel(std::move(socket), "zmq:" + place), guest_(std::move(token)), file_(std::move(file)) {
  socket_.set(zmq::sockopt::router_mandatory, true);  // to send to a peer that is gone is an error
}

/// One that is turned away may be told so before it has connected.
bool ServedZmqChannel::put(zmq::const_buffer frame) try {
  return socket_.send(zmq::buffer(guest_), zmq::send_flags::sndmore) && ZmqChannel::put(frame);
} catch (const zmq::error_t& error) {
  if (guest_is_in_ || error.num() != EHOSTUNREACH) throw;
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return false;
}

/// The first part of each message is the name of its sender. What is not the guest's is dropped.
bool ServedZmqChannel::take(bool waits) {
  zmq::message_t sender;
  if (!take_part(sender, waits)) return false;
  if (!sender.more() || !ZmqChannel::take(false)) return false;
  if (!guest_is_in_ && guest_.empty()) guest_ = sender.to_string();
  if (sender.to_string_view() == guest_) {
    if (!guest_is_in_) let_in();
    return true;
  }
  for (zmq::message_t rest; message_.more() && take_part(rest, false);) std::swap(message_, rest);
  return false;
}

/// ZeroMQ can't stop listening without an end to this connection too; where there is a file, nobody finds it
/// now.
void ServedZmqChannel::let_in() {
  guest_is_in_ = true;
  monitor_.watch(::zmq_msg_get(message_.handle(), ZMQ_SRCFD));
  file_ = SocketFile();
}

}  // namespace tandem::zeromq
