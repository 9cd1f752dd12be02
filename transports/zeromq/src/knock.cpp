// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <random>

#include "address.hpp"
#include "channel.hpp"
#include "gate.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace zeromq {
namespace {

constexpr const char* knock = "TANDEM\r\n";
constexpr std::size_t longest_token = 64;  // bytes
/// libzmq copies a message twice to encrypt it, and to decrypt it: a payload is smaller, so that a session is
/// not larger.
constexpr std::uint64_t longest_with_keys = 48U << 20U;  // bytes

/// 128 bits that nobody can guess, as text.
std::string new_token() {
  std::random_device random;
  std::string token;
  for (int part = 0; part < 4; ++part)
    for (unsigned digits = random(), k = 0; k < 8; ++k, digits >>= 4)
      token += "0123456789abcdef"[digits & 15];
  return token;
}

/// "tcp://127.0.0.1:0" as ZeroMQ writes it.
std::string to_bind(std::string address) {
  if (address.starts_with("tcp://") && address.ends_with(":0")) address.replace(address.size() - 1, 1, "*");
  return address;
}

/// Answers each knock with the address of a new socket that one peer can use.
class ZmqListener final : public wire::Listener {
 public:
  ZmqListener(const std::string& address, const ZmqSettings& settings)
      : settings_(settings), gate_(settings), socket_(context(), zmq::socket_type::router) {
    const std::string place = to_bind(to_open(address, settings));
    if (taken(address))
      throw Error(ErrorCode::input_output,
                  "no listening at zmq:" + address +
                      ": the file is there and in use; allowed are a path where there is "
                      "none, and a socket whose server is gone");
    try {
      secure(socket_, settings, Gate::door);
      bind_to(socket_, place);
      bound_ = socket_.get(zmq::sockopt::last_endpoint);
    } catch (const zmq::error_t& error) {
      fail("no listening at", address, error);
    }
    file_ = IpcFile(bound_);
    address_ = "zmq:" + bound_;
  }

  std::unique_ptr<wire::Channel> accept(wire::Deadline deadline) override {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    if (!readable(socket_, static_cast<int>(std::max<long long>(left.count(), 0)))) return nullptr;
    zmq::message_t peer;
    if (!socket_.recv(peer, zmq::recv_flags::dontwait)) return nullptr;
    std::array<std::string, 2> words;  // what else a stranger sends is read and dropped
    std::string key;
    bool more = peer.more();
    for (std::size_t k = 0; more; ++k) {
      zmq::message_t part;
      if (!socket_.recv(part, zmq::recv_flags::dontwait)) return nullptr;
      more = part.more();
      if (k < words.size() && part.size() <= longest_token) words[k] = part.to_string();
      if (has_keys()) key = part.gets("User-Id");
    }
    if (words[0] != knock || (has_keys() && key.empty())) return nullptr;
    return welcome(peer, words[1], key);
  }
  const std::string& address() const override { return address_; }

 private:
  bool has_keys() const { return !settings_.keys.secret_key.empty(); }

  /// token: how its socket will call itself; key: that it has shown, if there are keys.
  std::unique_ptr<wire::Channel> welcome(zmq::message_t& peer, const std::string& token,
                                         const std::string& key) {
    try {
      zmq::socket_t own(context(), zmq::socket_type::router);
      secure(own, settings_, key);
      while (taken(beside(bound_, ++count_))) {  // by a server of that name, or any file
      }
      bind_to(own, beside(bound_, count_));
      const std::string place = own.get(zmq::sockopt::last_endpoint);
      auto channel = std::make_unique<ServedZmqChannel>(std::move(own), token, place,
                                                        has_keys() ? longest_with_keys : wire::usual_longest);
      socket_.send(peer, zmq::send_flags::sndmore);
      socket_.send(zmq::buffer(place), zmq::send_flags::dontwait);
      return channel;
    } catch (const zmq::error_t& error) {
      fail("no socket for a session at", bound_, error);
    }
  }

  ZmqSettings settings_;
  Gate gate_;
  zmq::socket_t socket_;
  std::string bound_, address_;
  IpcFile file_;
  unsigned count_ = 0;
};

/// Knocks at a place, with the name of the socket that is to come; returns the place of the session.
std::string session_place(const std::string& address, const std::string& place, const std::string& token,
                          const ZmqSettings& settings) {
  zmq::socket_t door(context(), zmq::socket_type::dealer);
  secure(door, settings);
  door.set(zmq::sockopt::linger, 0);
  connect_to(door, place);
  door.send(zmq::buffer(std::string_view(knock)), zmq::send_flags::dontwait | zmq::send_flags::sndmore);
  door.send(zmq::buffer(token), zmq::send_flags::dontwait);
  const auto deadline = wire::in_seconds(settings.deadline);
  zmq::message_t answer;
  while (!door.recv(answer, zmq::recv_flags::dontwait)) {
    if (std::chrono::steady_clock::now() > deadline)
      throw Error(ErrorCode::input_output,
                  "no connection to zmq:" + address + " within the deadline" +
                      (settings.keys.secret_key.empty() ? "" : " (or the keys are not the right ones)"));
    readable(door, 20);
  }
  return beside(place, answer.to_string());
}

}  // namespace
}  // namespace zeromq

std::unique_ptr<wire::Channel> zmq_connect(const std::string& address, const ZmqSettings& settings) {
  const std::string door = zeromq::to_open(address, settings);
  try {
    const std::string token = zeromq::new_token();
    const std::string place = zeromq::session_place(address, door, token, settings);
    zmq::socket_t socket(zeromq::context(), zmq::socket_type::dealer);
    zeromq::secure(socket, settings);
    socket.set(zmq::sockopt::routing_id, token);
    zeromq::connect_to(socket, place);
    return std::make_unique<zeromq::ZmqChannel>(std::move(socket), "zmq:" + address);
  } catch (const zmq::error_t& error) {
    zeromq::fail("no connection to", address, error);
  }
}

std::unique_ptr<wire::Listener> zmq_listen(const std::string& address, const ZmqSettings& settings) {
  return std::make_unique<zeromq::ZmqListener>(address, settings);
}

}  // namespace tandem
