// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <random>
#include <vector>

#include "address.hpp"
#include "channel.hpp"
#include "gate.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace zeromq {
namespace {

constexpr const char* knock = "TANDEM\r\n";
constexpr std::size_t longest_token = 64;  // bytes
constexpr std::size_t longest_part = 256;  // bytes of a knock's part that is read; what is longer is no knock

/// What a peer says at the door: its name there, and two parts.
struct Knock {
  zmq::message_t peer;
  std::vector<std::string> words;
  std::string key;  ///< that it has shown

  /// A token has 1 to 64 bytes; there was none once.
  bool sound() const {
    if (words.empty() || words.size() > 2 || words[0] != knock) return false;
    return words.size() == 1 || (!words[1].empty() && words[1].size() <= longest_token);
  }
  std::string token() const { return words.size() > 1 ? words[1] : ""; }
};

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
                      ": something is there; allowed are a path where there is nothing, and a socket whose "
                      "server is gone");
    try {
      secure(socket_, settings, Gate::door);
      limit_messages(socket_, longest_part);
      file_ = bind_with_file(socket_, place);
      bound_ = socket_.get(zmq::sockopt::last_endpoint);
    } catch (const zmq::error_t& error) {
      fail("no listening at", address, error);
    }
    address_ = "zmq:" + bound_;
  }

  std::unique_ptr<wire::Channel> accept(wire::Deadline deadline) override {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    if (!readable(socket_, static_cast<int>(std::max<long long>(left.count(), 0)))) return nullptr;
    Knock peer;
    if (!hear(peer) || !peer.sound() || (has_keys() && peer.key.empty())) return nullptr;
    return welcome(peer);
  }
  const std::string& address() const override { return address_; }

 private:
  bool has_keys() const { return !settings_.keys.secret_key.empty(); }

  /// Further parts than those of a knock are read and dropped.
  bool hear(Knock& peer) {
    if (!socket_.recv(peer.peer, zmq::recv_flags::dontwait)) return false;
    for (bool more = peer.peer.more(); more;) {
      zmq::message_t part;
      if (!socket_.recv(part, zmq::recv_flags::dontwait)) return false;
      more = part.more();
      if (peer.words.size() < 3) peer.words.push_back(part.to_string());
      if (has_keys()) peer.key = part.gets("User-Id");
    }
    return true;
  }

  std::unique_ptr<wire::Channel> welcome(Knock& peer) {
    try {
      zmq::socket_t own(context(), zmq::socket_type::router);
      secure(own, settings_, peer.key);
      limit_messages(own, longest_served + wire::header_size);
      while (taken(beside(bound_, ++count_))) {  // by a server of that name, or any file
      }
      SocketFile file = bind_with_file(own, beside(bound_, count_));
      const std::string place = own.get(zmq::sockopt::last_endpoint);
      auto channel = std::make_unique<ServedZmqChannel>(std::move(own), peer.token(), place, std::move(file));
      socket_.send(peer.peer, zmq::send_flags::sndmore);
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
  SocketFile file_;
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

/// ms, 11 days: whoever takes the port after the session is not its peer. (With -1 libzmq drops what has come
/// before the connection's end and was not read yet.)
constexpr int never = 1'000'000'000;

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
    socket.set(zmq::sockopt::reconnect_ivl, zeromq::never);
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
