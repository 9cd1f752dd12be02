// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "gate.hpp"

#include <algorithm>
#include <array>

#include "tandem/error.hpp"

namespace tandem::zeromq {

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

/// Request: version, number, domain, address, identity, mechanism, key (32 bytes). Reply: version, number,
/// status, text, user, metadata.
void Gate::answer() {
  std::vector<zmq::message_t> parts;
  do {
    zmq::message_t part;
    if (!socket_.recv(part, zmq::recv_flags::dontwait)) break;
    parts.push_back(std::move(part));
  } while (parts.back().more());
  std::array<char, 41> key{};
  bool in = false;
  if (parts.size() == 7 && parts[5].to_string_view() == "CURVE" && parts[6].size() == 32) {
    ::zmq_z85_encode(key.data(), parts[6].data<std::uint8_t>(), 32);
    in = std::find(allowed_.begin(), allowed_.end(), key.data()) != allowed_.end() &&
         (parts[2].to_string_view() == door || parts[2].to_string_view() == key.data());
  }
  const std::string number = parts.size() > 1 ? parts[1].to_string() : "";
  const std::array<std::string, 6> reply = {
      "1.0", number, in ? "200" : "400", in ? "OK" : "key not known", in ? key.data() : "", ""};
  for (std::size_t k = 0; k < reply.size(); ++k)
    socket_.send(zmq::buffer(reply[k]),
                 k + 1 < reply.size() ? zmq::send_flags::sndmore : zmq::send_flags::none);
}

}  // namespace tandem::zeromq
