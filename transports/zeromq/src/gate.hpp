// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <atomic>
#include <thread>

#include "socket.hpp"

namespace tandem::zeromq {

/// Lets in the clients whose public keys are listed (the ZAP protocol, https://rfc.zeromq.org/spec/27/): at
/// the domain `door` each, at a domain that is a key the one who has that. One in a process at a time; none
/// is needed without keys.
class Gate {
 public:
  static constexpr const char* door = "tandem";
  explicit Gate(const ZmqSettings& settings);
  ~Gate();
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;

 private:
  using Request = std::array<zmq::message_t, 7>;
  void answer_all();
  void answer() noexcept;
  bool read(Request& request) noexcept;
  bool lets_in(const Request& request, std::array<char, 41>& key) const noexcept;

  std::vector<std::string> allowed_;
  zmq::socket_t socket_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace tandem::zeromq
