// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <functional>
#include <list>
#include <memory>
#include <string>

#include "tandem/wire/session.hpp"

namespace tandem::wire {

/// Where peers knock.
class Listener {
 public:
  virtual ~Listener() = default;
  /// The next connection; null if there was none by then, or a signal came. Throws Error if there is one and
  /// no descriptor or memory for it: it waits.
  virtual std::unique_ptr<Channel> accept(Deadline deadline) = 0;
  /// What a peer connects to, with the port that was found: "tcp://127.0.0.1:40123".
  virtual const std::string& address() const = 0;
};

struct ServerSettings {
  int most_sessions = 64;  ///< At a time; a further peer is told so.
  bool once = false;       ///< One session, and no more; a peer that says no whole hello has none.
  SessionSettings session = {};
  std::function<void(const std::string&)> log;  ///< Is told what sessions begin, end and break; may be empty.
  /// Called, with their number, when sessions go on computing for a deadline after somebody asked for the
  /// server's end. A model's computing can't be cut short but with the process. If it returns, or is empty,
  /// they are waited for.
  std::function<void(int)> overdue;
};

/// Serves each connection of a listener in a thread of its own, with a subsystem of its own.
class Server {
 public:
  Server(Listener& listener, MakeSubsystem make, ServerSettings settings);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Until stop() is true (looked at after each connection, after a signal and ten times a second), or after
  /// the one session of `once`. The sessions that are open then are closed.
  void run(const std::function<bool()>& stop);

 private:
  struct Guest;
  void take(std::unique_ptr<Channel> channel);
  void wait_out(const std::exception& error) noexcept;
  void turn_away(Channel& channel, const std::string& why);
  void wait_for_guest(const std::function<bool()>& stop);
  void hold_session(Channel& channel);
  void serve(Guest& guest) noexcept;
  void clear_away(bool all);
  void end_sessions();
  void log(const std::string& sentence) const;
  void log_end(const Guest& guest, const std::exception& why) const noexcept;

  Listener& listener_;
  MakeSubsystem make_;
  ServerSettings settings_;
  std::list<Guest> guests_;
  std::atomic<bool> greeted_ = false;  ///< a session has begun with a hello
  std::string shortage_;               ///< why the last connection could not be taken
};

}  // namespace tandem::wire
