// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "bench/answer.hpp"
#include "tandem/wire/remote_subsystem.hpp"
#include "tandem/wire/server.hpp"

namespace tandem::bench {

/// A folder with what the transports need of files: sockets' names, certificates ("server.key", "client.key",
/// "authority.crt"), CURVE keys ("curve_server", "curve_client" and their ".pub"). It goes with its owner.
class LinkFolder {
 public:
  LinkFolder();
  ~LinkFolder();
  LinkFolder(const LinkFolder&) = delete;
  LinkFolder& operator=(const LinkFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  void write(const std::string& name, const std::string& text) const;
  void write_certificates() const;
  std::filesystem::path path_;
};

/// A session over one of the transports that this build has ("tcp", "unix", "tls", "zmq:tcp", "zmq:ipc",
/// "zmq:curve") with a subsystem that answers, served by a thread pinned to places().there.
class AnswerLink {
 public:
  /// spin [s]: how long both ends look before they sleep; those of ZeroMQ sleep at once.
  AnswerLink(const std::string& transport, const Shape& shape, double spin, const LinkFolder& folder);
  ~AnswerLink();
  AnswerLink(const AnswerLink&) = delete;
  AnswerLink& operator=(const AnswerLink&) = delete;
  void exchange() { asking_->once(); }

 private:
  struct Ends {
    std::unique_ptr<wire::Listener> listener;
    std::function<std::unique_ptr<wire::Channel>(const std::string& address)> connect;
  };
  static Ends socket_ends(const std::string& transport, double spin, const LinkFolder& folder);
  static Ends zeromq_ends(const std::string& transport, const LinkFolder& folder);
  void serve(const Shape& shape);

  std::unique_ptr<wire::Listener> listener_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
  std::unique_ptr<wire::RemoteSubsystem> remote_;
  std::unique_ptr<Asking> asking_;
};

/// The names of those transports.
std::vector<std::string> linked_transports();

}  // namespace tandem::bench
