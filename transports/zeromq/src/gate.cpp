// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "gate.hpp"

#include <algorithm>
#include <cerrno>
#include <string_view>

#include "tandem/error.hpp"

namespace tandem::zeromq {
namespace {

/// A signal that interrupts a call of libzmq changes nothing.
template <class Call>
int persist(const Call& call) noexcept {
  int result = call();
  while (result < 0 && ::zmq_errno() == EINTR) result = call();
  return result;
}

}  // namespace

Gate::Gate(const ZmqSettings& settings) {
  if (settings.keys.secret_key.empty()) return;
  if (settings.clients.empty())
    throw Error(ErrorCode::invalid_argument,
                "a server with keys needs the public keys of the clients that it lets in");
  allowed_ = settings.clients;
  try {
    socket_ = zmq::socket_t(context(), zmq::socket_type::rep);
    socket_.set(zmq::sockopt::linger, 0);
    socket_.bind("inproc://zeromq.zap.01");
  } catch (const zmq::error_t& error) {
    fail("no second server with keys in one process:", "inproc://zeromq.zap.01", error);
  }
  thread_ = std::thread([this] { answer_all(); });
}

Gate::~Gate() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void Gate::answer_all() {
  while (!stop_)
    if (readable(socket_, 50)) answer();
}

/// Takes the parts of a request: version, number, domain, address, identity, mechanism, key (32 bytes).
/// Nothing here throws: an exception would end the process, with all its sessions.
bool Gate::read(Request& request) noexcept {
  std::size_t count = 0;
  for (bool more = true; more; ++count) {
    zmq::message_t part;
    if (persist([&] { return ::zmq_msg_recv(part.handle(), socket_.handle(), ZMQ_DONTWAIT); }) < 0)
      return false;
    more = part.more();
    if (count < request.size()) request[count].swap(part);
  }
  return count == request.size();
}

bool Gate::lets_in(const Request& request, std::array<char, 41>& key) const noexcept {
  if (request[5].to_string_view() != "CURVE" || request[6].size() != 32) return false;
  ::zmq_z85_encode(key.data(), request[6].data<std::uint8_t>(), 32);
  return std::find(allowed_.begin(), allowed_.end(), key.data()) != allowed_.end() &&
         (request[2].to_string_view() == door || request[2].to_string_view() == key.data());
}

/// Version, number, status, text, user, metadata. What is longer than a few bytes takes memory: without that
/// the client is not let in. The rest of a reply that has begun can be sent.
void Gate::answer() noexcept {
  Request request;
  std::array<char, 41> key{};
  zmq_msg_t user;
  bool in = read(request) && lets_in(request, key) && ::zmq_msg_init_size(&user, 40) == 0;
  if (in) std::copy_n(key.begin(), 40, static_cast<char*>(::zmq_msg_data(&user)));
  if (!in) ::zmq_msg_init(&user);
  const auto put = [this](std::string_view text, int flags = ZMQ_SNDMORE) {
    persist([&] { return ::zmq_send(socket_.handle(), text.data(), text.size(), flags); });
  };
  put("1.0");
  put(request[1].to_string_view());
  put(in ? "200" : "400");
  put(in ? "OK" : "key not known");
  persist([&] { return ::zmq_msg_send(&user, socket_.handle(), ZMQ_SNDMORE); });
  put("", 0);
  ::zmq_msg_close(&user);
}

}  // namespace tandem::zeromq
