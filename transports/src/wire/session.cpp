// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/wire/session.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "tandem/error.hpp"

namespace tandem::wire {
namespace {

/// What the subsystem says: an answer like any other.
template <class Call>
auto asked(const Call& call) {
  try {
    return call();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ErrorCode::internal, error.what());
  }
}

std::string seconds_text(double seconds) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.begin(), text.end(), seconds).ptr};
}

}  // namespace

Session::Session(Channel& channel, MakeSubsystem make, SessionSettings settings)
    : channel_(channel), make_(std::move(make)), settings_(std::move(settings)) {}

void Session::serve() {
  try {
    while (answer()) {
    }
  } catch (const Error& error) {
    try {
      send_error(error);
    } catch (const Error&) {  // the first one is the one to be heard of
    }
    throw;
  }
}

/// One request. False: there is none any more. What goes wrong before its number is known to be right is told
/// with the number 0.
bool Session::answer() {
  const std::uint32_t last = std::exchange(number_, 0);
  if (!channel_.wait(in_seconds(settings_.idle)))
    throw Error(ErrorCode::input_output,
                "no request came within " + seconds_text(settings_.idle) + " s, so the session ends");
  const auto bytes = channel_.receive(in_seconds(settings_.deadline));
  if (bytes.empty()) return false;
  const Frame request = Frame::read(bytes, usual_longest);
  check_number(request.header, last + 1);
  if (request.header.type == Type::bye) {
    say_bye();
    return false;
  }
  check_order(request.header.type);
  handle(request);
  return true;
}

/// The peer need not wait for it.
void Session::say_bye() {
  try {
    reply(Type::bye);
    send();
  } catch (const Error&) {
  }
}

/// So that one that comes twice is not done twice.
void Session::check_number(const Header& header, std::uint32_t allowed) {
  if (header.number != allowed)
    throw Error(ErrorCode::wrong_state, "the request has the number " + std::to_string(header.number) +
                                            "; allowed is " + std::to_string(allowed));
  number_ = header.number;
}

void Session::check_order(Type type) const {
  const bool first = type == Type::hello;
  const bool sound = first ? !subsystem_
                           : subsystem_ && (initialized_ || type == Type::info || type == Type::initialize ||
                                            type == Type::ping);
  if (!sound)
    throw Error(ErrorCode::wrong_state, "the request '" + std::string(name(type)) +
                                            "' is out of order; allowed is hello once, then info, then "
                                            "initialize before all others");
}

void Session::handle(const Frame& request) {
  switch (request.header.type) {
    case Type::hello:
      return hello(request);
    case Type::initialize:
      return initialize(request);
    case Type::advance:
      return advance(request);
    case Type::info:
      read_nothing(request);
      reply(Type::info);
      put_info(frame_, subsystem_->info());
      return send();
    case Type::ping:
      reply(Type::ping);
      frame_.put_bytes(request.payload);
      return send();
    case Type::save:
    case Type::restore:
    case Type::release:
    case Type::serialize:
    case Type::deserialize:
      return handle_state(request);
    default:
      throw Error(ErrorCode::wrong_state, "'" + std::string(name(request.header.type)) + "' is no request");
  }
}

void Session::handle_state(const Frame& request) {
  const Type type = request.header.type;
  if (type == Type::save) read_nothing(request);
  const bool names_one = type != Type::save && type != Type::deserialize;
  const StateId id = names_one ? read_id(request.payload) : 0;
  try {
    reply(type);
    if (type == Type::save) put_id(frame_, asked([&] { return subsystem_->save_state(); }));
    if (type == Type::restore) put_clock(frame_, asked([&] { return subsystem_->restore_state(id); }));
    if (type == Type::release) asked([&] { subsystem_->release_state(id); });
    if (type == Type::serialize) frame_.put_bytes(asked([&] { return bytes_of(id); }));
    if (type == Type::deserialize)
      put_id(frame_, asked([&] { return subsystem_->deserialize_state(request.payload); }));
    send();
  } catch (const Error& error) {
    send_error(error);
  }
}

/// Of a state, if the peer takes that many.
std::vector<std::byte> Session::bytes_of(StateId id) {
  auto bytes = subsystem_->serialize_state(id);
  if (const auto most = std::min(longest_, usual_longest); bytes.size() > most)
    throw Error(ErrorCode::not_supported, "the state has " + std::to_string(bytes.size()) +
                                              " bytes; a reply may have up to " + std::to_string(most));
  return bytes;
}

void Session::hello(const Frame& request) {
  const Hello hello = read_hello(request.payload);
  if (hello.lowest_version > protocol_version || hello.highest_version < protocol_version)
    throw Error(ErrorCode::not_supported, "the peer speaks version " + std::to_string(hello.lowest_version) +
                                              " to " + std::to_string(hello.highest_version) +
                                              " of the protocol; allowed is " +
                                              std::to_string(protocol_version));
  if (hello.longest < shortest_limit)
    throw Error(ErrorCode::not_supported, "the peer takes payloads of up to " +
                                              std::to_string(hello.longest) + " bytes; allowed are " +
                                              std::to_string(shortest_limit) + " or more");
  longest_ = hello.longest;
  subsystem_ = asked([&] { return make_(hello.text); });
  reply(Type::hello);
  put_hello(frame_, {.text = settings_.software});
  send();
}

/// Rows for one reply: as many as are asked for and fit. Nothing is written to them, so that the system gives
/// their memory page by page, as rows come.
Samples Session::rows(std::uint64_t room) {
  const auto stride = static_cast<std::uint64_t>(subsystem_->info().row_size());
  const std::uint64_t fit = (std::min(longest_, usual_longest) - samples_head) / (8 * stride);
  const std::uint64_t capacity = std::min(room, fit);
  if (capacity == 0)
    throw Error(ErrorCode::invalid_argument,
                "there is room for no row of " + std::to_string(8 * stride) + " bytes in a reply");
  if (const std::uint64_t numbers = capacity * stride; numbers > held_) {
    memory_ = std::make_unique_for_overwrite<double[]>(numbers);
    held_ = numbers;
  }
  return {memory_.get(), static_cast<std::int64_t>(stride), static_cast<std::int64_t>(capacity)};
}

template <class Call>
void Session::reply_with_rows(std::uint64_t room, const Call& call) {
  Samples y = rows(room);
  try {
    const Clock clock = asked([&] { return call(y); });
    reply(Type::samples);
    put_samples(frame_, clock, y, 0);
  } catch (const Error& error) {
    reply(Type::error);
    put_error(frame_, error, y, 0);
  }
  send();
}

void Session::initialize(const Frame& request) {
  read_initialize(request.payload, subsystem_->info().input_size(), initialize_);
  initialized_ = true;
  reply_with_rows(initialize_.room, [&](Samples& y) {
    return subsystem_->initialize(initialize_.t_start, initialize_.t_stop, initialize_.u0, y);
  });
}

void Session::advance(const Frame& request) {
  read_advance(request.payload, subsystem_->info().input_size(), advance_);
  reply_with_rows(advance_.room, [&](Samples& y) {
    return subsystem_->advance(advance_.t_limit, advance_.land, advance_.signals, y);
  });
}

void Session::reply(Type type) { begin(frame_, type, number_); }

void Session::send() {
  finish(frame_);
  channel_.send(frame_.bytes(), in_seconds(settings_.deadline));
}

void Session::send_error(const Error& error) {
  reply(Type::error);
  put_error(frame_, error.code(), error.what());
  send();
}

}  // namespace tandem::wire
