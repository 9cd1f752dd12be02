// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include "address.hpp"
#include "gate.hpp"
#include "ipc_file.hpp"
#include "socket.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace zeromq {
namespace {

constexpr const char* knock = "TANDEM\r\n";

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
      secure(socket_, settings, true);
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
    zmq::message_t peer, word;
    if (!socket_.recv(peer, zmq::recv_flags::dontwait)) return nullptr;
    bool more = peer.more();
    for (bool first = true; more; first = false) {  // what else a stranger sends is read and dropped
      zmq::message_t part;
      if (!socket_.recv(part, zmq::recv_flags::dontwait)) return nullptr;
      more = part.more();
      if (first) word = std::move(part);
    }
    if (word.to_string_view() != knock) return nullptr;
    return welcome(peer);
  }
  const std::string& address() const override { return address_; }

 private:
  std::unique_ptr<wire::Channel> welcome(zmq::message_t& peer) {
    try {
      zmq::socket_t own(context(), zmq::socket_type::dealer);
      secure(own, settings_, true);
      while (taken(beside(bound_, ++count_))) {  // by a server of that name, or any file
      }
      bind_to(own, beside(bound_, count_));
      const std::string place = own.get(zmq::sockopt::last_endpoint);
      auto channel = std::make_unique<ZmqChannel>(std::move(own), "zmq:" + place, IpcFile(place));
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

/// Knocks at a place; returns that of the session.
std::string session_place(const std::string& address, const std::string& place, const ZmqSettings& settings) {
  zmq::socket_t door(context(), zmq::socket_type::dealer);
  secure(door, settings, false);
  door.set(zmq::sockopt::linger, 0);
  connect_to(door, place);
  door.send(zmq::str_buffer("TANDEM\r\n"), zmq::send_flags::dontwait);
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
    const std::string place = zeromq::session_place(address, door, settings);
    zmq::socket_t socket(zeromq::context(), zmq::socket_type::dealer);
    zeromq::secure(socket, settings, false);
    auto channel = std::make_unique<zeromq::ZmqChannel>(std::move(socket), "zmq:" + address);
    channel->connect(place);
    return channel;
  } catch (const zmq::error_t& error) {
    zeromq::fail("no connection to", address, error);
  }
}

std::unique_ptr<wire::Listener> zmq_listen(const std::string& address, const ZmqSettings& settings) {
  return std::make_unique<zeromq::ZmqListener>(address, settings);
}

}  // namespace tandem
