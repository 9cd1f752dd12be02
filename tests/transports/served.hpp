// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "examples.hpp"
#include "tandem/tcp/tcp.hpp"
#include "tandem/wire/messages.hpp"
#if TANDEM_HAS_ZEROMQ
#include "tandem/zeromq/zeromq.hpp"
#endif

namespace tandem::test {

/// Sources of the two masses and every transport.
inline Builtins all_sources() {
  Builtins builtins = library_sources();
  add_tcp(builtins);
#if TANDEM_HAS_ZEROMQ
  add_zeromq(builtins);
#endif
  return builtins;
}

/// A server in a thread of this program, at a listener.
class Served {
 public:
  Served(std::unique_ptr<wire::Listener> listener, wire::MakeSubsystem make,
         wire::ServerSettings settings = {})
      : listener_(std::move(listener)) {
    settings.log = [this](const std::string& sentence) {
      const std::lock_guard lock(mutex_);
      log_.push_back(sentence);
    };
    server_ = std::make_unique<wire::Server>(*listener_, std::move(make), std::move(settings));
    thread_ = std::thread([this] { server_->run([this] { return stop_.load(); }); });
  }
  ~Served() {
    stop_ = true;
    thread_.join();
  }
  Served(const Served&) = delete;
  Served& operator=(const Served&) = delete;

  const std::string& address() const { return listener_->address(); }
  std::vector<std::string> log() const {
    const std::lock_guard lock(mutex_);
    return log_;
  }

 private:
  std::unique_ptr<wire::Listener> listener_;
  std::unique_ptr<wire::Server> server_;
  std::atomic<bool> stop_ = false;
  mutable std::mutex mutex_;
  std::vector<std::string> log_;
  std::thread thread_;
};

/// Connects to a server and goes: without a word, and after half a hello.
inline void scan_ports(const std::string& address) {
  for (const std::size_t bytes : {0, 20}) {
    const auto channel = connect(address, {});
    wire::Writer frame;
    wire::begin(frame, wire::Type::hello, 1);
    wire::put_hello(frame, {});
    wire::finish(frame);
    channel->send(frame.bytes().first(bytes), wire::in_seconds(5.0));
  }
}

/// What serves a source of all_sources(), each session with parameters of its own.
inline wire::MakeSubsystem source(const std::string& uri) {
  return [uri](const std::string& parameters) {
    Opening opening;
    if (!parameters.empty()) opening.parameters.read(parameters, uri);
    return open(uri, all_sources(), std::move(opening));
  };
}

}  // namespace tandem::test
