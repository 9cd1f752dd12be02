// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "tandem/subsystem.hpp"
#include "tandem/wire/channel.hpp"
#include "tandem/wire/kept_states.hpp"
#include "tandem/wire/messages.hpp"

namespace tandem::wire {

/// Makes the subsystem of a session from "key=value&key=value", or "".
using MakeSubsystem = std::function<std::unique_ptr<Subsystem>(const std::string& parameters)>;

struct SessionSettings {
  /// [s]: for the first request, for a frame to come whole once it has begun, and for a reply to be taken.
  double deadline = 5.0;
  double idle = 3600.0;             ///< [s]: from one request to the next
  std::string software = "tandem";  ///< what hello says
};

/// The serving side of one connection: answers requests until the peer says bye or is gone.
class Session {
 public:
  Session(Channel& channel, MakeSubsystem make, SessionSettings settings = {});

  /// To the end of the session. Throws Error for what broke the protocol or the connection, told to the peer
  /// if it can be.
  void serve();
  /// Whether the peer has said a whole hello, by which one of tandem's is told from a port scan.
  bool greeted() const { return greeted_; }

 private:
  std::span<const std::byte> next();
  bool answer();
  void say_bye();
  void handle(const Frame& request);
  void handle_state(const Frame& request);
  void answer_state(const Frame& request, StateId id);
  std::vector<std::byte> bytes_of(StateId id);
  void check_number(const Header& header, std::uint32_t allowed);
  void check_order(Type type) const;
  void hello(const Frame& request);
  void initialize(const Frame& request);
  void advance(const Frame& request);
  void sample(const Frame& request);
  void require_carried() const;
  /// For rows that end with so many states of a reaction.
  struct Room {
    std::uint64_t rows;
    std::int32_t states;
  };
  Samples rows(const Room& room);
  template <class Call>
  void reply_with_rows(const Room& room, const Call& call);
  void reply(Type type);
  void send();
  void send_error(const Error& error);
  bool carries(std::uint32_t capability) const { return (capabilities_ & capability) != 0; }

  Channel& channel_;
  MakeSubsystem make_;
  SessionSettings settings_;
  std::unique_ptr<Subsystem> subsystem_;
  bool greeted_ = false, initialized_ = false;
  std::uint32_t number_ = 0;        ///< of the request that is answered; 0 before it is there
  std::uint64_t longest_ = 0;       ///< payload that is given
  std::uint32_t capabilities_ = 0;  ///< of both sides
  Writer frame_;
  Initialize initialize_;
  Advance advance_;
  Sample sample_;
  std::vector<double> outputs_;  ///< of a sample
  KeptStates states_;
};

}  // namespace tandem::wire
