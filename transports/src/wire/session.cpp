// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/wire/session.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/printable.hpp"

namespace tandem::wire {
namespace {

/// The same with an Error in place of any other exception.
template <class Call>
auto asked(const Call& call) {
  try {
    return call();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ErrorCode::internal, sentence_of(error));
  } catch (...) {
    throw Error(ErrorCode::internal, "it threw what is no exception");
  }
}

/// Memory that a request or a reply has left is given back if it is more.
constexpr std::size_t usual_memory = 1 << 22;  // bytes
/// For the last word to a peer that has said no whole hello. Nothing was sent before it that would be in its
/// way, and over ZeroMQ there may be nobody to take it.
constexpr double farewell = 0.1;  // s

template <class T>
void release_large(std::vector<T>& memory) {
  if (memory.capacity() * sizeof(T) > usual_memory) memory = std::vector<T>();
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
    while (asked([this] { return answer(); })) {
    }
  } catch (const Error& error) {
    try {
      send_error(error);
    } catch (const Error&) {  // the first one is the one to be heard of
    }
    throw;
  }
}

/// The next request. The hello has one deadline from its first byte to its last, and for the wait before it.
std::span<const std::byte> Session::next() {
  const double patience = subsystem_ ? settings_.idle : settings_.deadline;
  const Deadline deadline = in_seconds(patience);
  if (!channel_.wait(deadline))
    throw Error(ErrorCode::input_output, std::string("no ") + (subsystem_ ? "request" : "hello") +
                                             " came within " + seconds_text(patience) +
                                             " s, so the session ends");
  return channel_.receive(subsystem_ ? in_seconds(settings_.deadline) : deadline);
}

/// One request. False: there is none any more. What goes wrong before its number is known to be right is told
/// with the number 0.
bool Session::answer() {
  const std::uint32_t last = std::exchange(number_, 0);
  const auto bytes = next();
  if (bytes.empty()) return false;
  const Frame request = Frame::read(bytes, channel_.longest());
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
    case Type::sample:
      return sample(request);
    case Type::info:
      read_nothing(request);
      reply(Type::info);
      put_info(frame_, subsystem_->info(), capabilities_);
      return send();
    case Type::ping:
      reply(Type::ping);
      frame_.put_bytes(request.payload);
      channel_.forget();
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
    asked([&] { answer_state(request, id); });
    send();
  } catch (const Error& error) {
    send_error(error);
  }
}

void Session::answer_state(const Frame& request, StateId id) {
  const Type type = request.header.type;
  if (type == Type::save) put_id(frame_, states_.save(*subsystem_));
  if (type == Type::restore) put_clock(frame_, subsystem_->restore_state(id));
  if (type == Type::release) states_.release(*subsystem_, id);
  if (type == Type::serialize) frame_.put_bytes(bytes_of(id));
  if (type == Type::deserialize) put_id(frame_, states_.deserialize(*subsystem_, request.payload));
}

/// Of a state, if the peer takes that many.
std::vector<std::byte> Session::bytes_of(StateId id) {
  auto bytes = subsystem_->serialize_state(id);
  if (const auto most = longest_; bytes.size() > most)
    throw Error(ErrorCode::not_supported, "the state has " + std::to_string(bytes.size()) +
                                              " bytes; a reply may have up to " + std::to_string(most));
  return bytes;
}

void Session::hello(const Frame& request) {
  const Hello hello = read_hello(request.payload);
  greeted_ = true;
  if (hello.lowest_version > protocol_version || hello.highest_version < protocol_version)
    throw Error(ErrorCode::not_supported, "the peer speaks version " + std::to_string(hello.lowest_version) +
                                              " to " + std::to_string(hello.highest_version) +
                                              " of the protocol; allowed is " +
                                              std::to_string(protocol_version));
  if (hello.longest < shortest_limit)
    throw Error(ErrorCode::not_supported, "the peer takes payloads of up to " +
                                              std::to_string(hello.longest) + " bytes; allowed are " +
                                              std::to_string(shortest_limit) + " or more");
  if (printable(hello.text, hello.text.size()) != hello.text)
    throw Error(ErrorCode::invalid_argument,
                "the parameters hold what is no text: '" + printable(hello.text, 200) + "'");
  longest_ = std::min(hello.longest, channel_.longest());
  capabilities_ = hello.capabilities & all_capabilities;
  subsystem_ = asked([&] { return make_(hello.text); });
  require_carried();
  Hello answer{.longest = channel_.longest(), .text = settings_.software};
  if (carries(carries_parameters)) answer.declared = subsystem_->info().parameters;
  reply(Type::hello);
  put_hello(frame_, answer);
  send();
}

/// A peer that was written before held outputs would take them for continuous ones.
void Session::require_carried() const {
  const SubsystemInfo& info = subsystem_->info();
  if ((info.holds() || info.abilities.sampled) && !carries(carries_held))
    throw Error(ErrorCode::not_supported,
                "subsystem '" + info.name +
                    "' has held outputs or is sampled, of which the peer does not speak (capability 1)");
}

/// Rows for one reply: as many as are asked for and fit. They are made where the reply has them, and the
/// system gives their memory page by page, as they come.
Samples Session::rows(const Room& room) {
  const auto stride = static_cast<std::uint64_t>(subsystem_->info().row_size() + room.states);
  const std::uint64_t fit = (longest_ - samples_head) / (8 * stride);
  const std::uint64_t capacity = std::min(room.rows, fit);
  if (capacity == 0)
    throw Error(ErrorCode::invalid_argument,
                "there is room for no row of " + std::to_string(8 * stride) + " bytes in a reply");
  return room_for_rows(frame_, static_cast<std::int64_t>(stride), static_cast<std::int64_t>(capacity));
}

template <class Call>
void Session::reply_with_rows(const Room& room, const Call& call) {
  channel_.forget();
  reply(Type::samples);
  Samples y = rows(room);
  try {
    const Clock clock = asked([&] { return call(y); });
    put_samples(frame_, clock, y);
  } catch (const Error& error) {
    frame_.put_at(type_place, static_cast<std::uint32_t>(Type::error));
    put_error(frame_, error, y);
  }
  release_large(advance_.segments);
  release_large(advance_.signals);
  release_large(initialize_.u0);
  send();
}

void Session::initialize(const Frame& request) {
  read_initialize(request.payload, subsystem_->info().input_size(), initialize_);
  initialized_ = true;
  reply_with_rows({initialize_.room, 0}, [&](Samples& y) {
    return subsystem_->initialize(initialize_.t_start, initialize_.t_stop, initialize_.u0, y);
  });
}

void Session::advance(const Frame& request) {
  const Scalars scalars = Scalars::of(subsystem_->info(), carries(carries_reactions));
  read_advance(request.payload, scalars, advance_, channel_.longest());
  reply_with_rows({advance_.room, advance_.reaction.view.states}, [&](Samples& y) {
    return subsystem_->advance(advance_.t_limit, advance_.land, advance_.signals, y);
  });
}

void Session::sample(const Frame& request) {
  const SubsystemInfo& info = subsystem_->info();
  read_sample(request.payload, info.input_size(), sample_);
  const bool gives = sample_.part != SamplePart::states;
  outputs_.resize(gives ? static_cast<std::size_t>(info.output_size()) : 0);
  try {
    const Clock clock =
        asked([&] { return subsystem_->sample(sample_.t, sample_.part, sample_.u, outputs_); });
    reply(Type::sample);
    put_sampled(frame_, clock, outputs_);
    send();
  } catch (const Error& error) {
    send_error(error);
  }
}

void Session::reply(Type type) { begin(frame_, type, number_); }

void Session::send() {
  finish(frame_);
  channel_.send(frame_.bytes(), in_seconds(greeted_ ? settings_.deadline : farewell));
  frame_.release_beyond(usual_memory);
}

void Session::send_error(const Error& error) {
  reply(Type::error);
  if (const auto* not_made = dynamic_cast<const NotMade*>(&error); not_made && carries(carries_parameters))
    put_error(frame_, *not_made);
  else
    put_error(frame_, error.code(), error.what());
  send();
}

}  // namespace tandem::wire
