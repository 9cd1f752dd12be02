// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "monitor.hpp"

#include <atomic>
#include <cstring>

namespace tandem::zeromq {

Monitor::Monitor(zmq::socket_t& socket) : socket_(socket), events_(context(), zmq::socket_type::pair) {
  static std::atomic<unsigned> count = 0;
  const std::string name = "inproc://tandem-monitor-" + std::to_string(++count);
  ::zmq_socket_monitor(socket.handle(), name.c_str(), ZMQ_EVENT_ACCEPTED | ZMQ_EVENT_DISCONNECTED);
  events_.set(zmq::sockopt::linger, 0);
  events_.set(zmq::sockopt::rcvhwm, 0);  // ZeroMQ's own thread waits for ever where an event has no room
  events_.connect(name);
}

/// ZeroMQ's own thread would wait for ever to tell of an event that nobody listens to any more.
Monitor::~Monitor() { ::zmq_socket_monitor(socket_.handle(), nullptr, 0); }

/// An event is two parts: its kind (u16) with the descriptor (u32), and an address.
void Monitor::listen() {
  for (zmq::message_t event, address; events_.recv(event, zmq::recv_flags::dontwait);) {
    std::uint16_t kind = 0;
    std::uint32_t descriptor = 0;
    if (event.size() == sizeof kind + sizeof descriptor) {
      std::memcpy(&kind, event.data(), sizeof kind);
      std::memcpy(&descriptor, event.data<char>() + sizeof kind, sizeof descriptor);
      hear(kind, static_cast<int>(descriptor));
    }
    if (event.more() && !events_.recv(address, zmq::recv_flags::dontwait)) return;
  }
}

void Monitor::hear(std::uint16_t kind, int descriptor) {
  if (kind == ZMQ_EVENT_ACCEPTED) ended_.erase(descriptor);
  if (kind != ZMQ_EVENT_DISCONNECTED) return;
  ended_.insert(descriptor);
  if (descriptor == watched_) watched_ended_ = true;
}

bool Monitor::any_ended() {
  listen();
  return !ended_.empty();
}

/// That it has been accepted was told before its first message came.
void Monitor::watch(int descriptor) {
  listen();
  watched_ = descriptor;
  watched_ended_ = ended_.contains(descriptor);
}

bool Monitor::watched_ended() {
  listen();
  return watched_ended_;
}

}  // namespace tandem::zeromq
