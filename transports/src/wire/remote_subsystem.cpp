// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/wire/remote_subsystem.hpp"

#include <charconv>

#include "reply_checks.hpp"
#include "tandem/error.hpp"

namespace tandem::wire {
namespace {

std::string number_text(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

/// What the subsystem itself says; the connection is as sound as before.
struct Told {
  Error error;
};

/// A channel is told when, not how long from now that is.
std::string with_length(std::string sentence, double deadline) {
  if (sentence.ends_with("within the deadline")) sentence += " of " + number_text(deadline) + " s";
  return sentence;
}

}  // namespace

/// An error of the connection ends its use; each error names the address, the call and the time in the run.
template <class Call>
auto RemoteSubsystem::told(const Call& call) {
  const auto where = [this] {
    const bool running = request_ != Type::hello && request_ != Type::info;
    return channel_->peer() + ", " + std::string(name(request_)) +
           (running ? " at t = " + number_text(time_) + " s" : "") +
           (request_ == Type::advance ? " to " + number_text(goal_) + " s: " : ": ");
  };
  if (!broken_.empty())
    throw Error(ErrorCode::wrong_state, channel_->peer() + ": the connection ended before: " + broken_);
  try {
    return call();
  } catch (const Told& told) {
    throw Error(told.error.code(), where() + told.error.what());
  } catch (const Error& error) {
    broken_ = with_length(error.what(), deadline_);
    channel_->close();
    throw Error(error.code(), where() + broken_);
  }
}

RemoteSubsystem::RemoteSubsystem(std::unique_ptr<Channel> channel, const std::string& parameters,
                                 double deadline)
    : channel_(std::move(channel)), deadline_(deadline) {
  try {
    hello(parameters);
  } catch (const Error& error) {
    if (info_.parameters.empty()) throw;
    throw NotMade(error, info_.parameters);
  }
  told([&] {
    begin(Type::info);
    DeclaredParameters declared = std::move(info_.parameters);
    info_ = read_info(exchange(Type::info).payload, capabilities_);
    info_.parameters = std::move(declared);
    if ((capabilities_ & carries_reactions) == 0) info_.abilities.reactive_inputs = false;
  });
}

RemoteSubsystem::~RemoteSubsystem() {
  if (!broken_.empty()) return;
  try {
    begin(Type::bye);
    send();
  } catch (const std::exception&) {  // it goes in any case
  }
}

void RemoteSubsystem::hello(const std::string& parameters) {
  told([&] {
    Hello reply = greeting(parameters);
    if (reply.lowest_version != protocol_version || reply.highest_version != protocol_version)
      throw Error(ErrorCode::not_supported,
                  "the peer speaks version " + std::to_string(reply.lowest_version) + " to " +
                      std::to_string(reply.highest_version) + " of the protocol; allowed is " +
                      std::to_string(protocol_version));
    longest_ = reply.longest;
    capabilities_ = reply.capabilities & all_capabilities;
    if (reply.declared) info_.parameters = std::move(*reply.declared);
    check_given(info_.parameters, parameters);
  });
}

/// What the peer refuses in its own words is said here if it can be, as it may not know the nearest name.
Hello RemoteSubsystem::greeting(const std::string& parameters) {
  begin(Type::hello);
  put_hello(frame_, {.text = parameters});
  try {
    return read_hello(exchange(Type::hello).payload, all_capabilities);
  } catch (const Told&) {
    check_given(info_.parameters, parameters);
    throw;
  }
}

void RemoteSubsystem::begin(Type type) {
  request_ = type;
  wire::begin(frame_, type, ++number_);
}

void RemoteSubsystem::send() {
  finish(frame_);
  if (frame_.size() - header_size > longest_)
    throw Error(ErrorCode::not_supported, "the request has " + std::to_string(frame_.size() - header_size) +
                                              " bytes; the peer takes up to " + std::to_string(longest_));
  try {
    channel_->send(frame_.bytes(), in_seconds(deadline_));
  } catch (const Error&) {
    hear_farewell();
    throw;
  }
}

/// A server that ended the session may have said why before it closed.
void RemoteSubsystem::hear_farewell() {
  std::span<const std::byte> bytes;
  try {
    bytes = channel_->receive(in_seconds(0.1));
  } catch (const Error&) {  // it has not, and why nothing can be sent is told
  }
  if (bytes.empty()) return;
  const Frame last = Frame::read(bytes, usual_longest);
  if (last.header.type == Type::error) throw read_error(last.payload, nullptr);
}

/// The reply to the last request.
Frame RemoteSubsystem::receive(Type expected, Samples* y) {
  const auto bytes = channel_->receive(in_seconds(deadline_));
  if (bytes.empty()) throw Error(ErrorCode::input_output, "the peer closed the connection");
  const Frame reply = Frame::read(bytes, usual_longest);
  if (reply.header.type == Type::error && reply.header.number == 0) throw read_error(reply.payload, nullptr);
  if (reply.header.number != number_)
    throw Error(ErrorCode::wrong_state, "the reply has the number " + std::to_string(reply.header.number) +
                                            "; allowed is that of the request, " + std::to_string(number_));
  if (reply.header.type == Type::error && expected == Type::hello)
    throw Told{read_error(reply.payload, info_.parameters)};
  if (reply.header.type == Type::error) throw Told{read_error(reply.payload, y)};
  if (reply.header.type != expected)
    throw Error(ErrorCode::wrong_state, "the reply is of the type '" + std::string(name(reply.header.type)) +
                                            "'; allowed are '" + std::string(name(expected)) +
                                            "' and 'error'");
  return reply;
}

Frame RemoteSubsystem::exchange(Type expected, Samples* y) {
  send();
  return receive(expected, y);
}

/// Rows that y has room for, and a reply too.
std::uint64_t RemoteSubsystem::room(const Samples& y) const {
  const tandem_samples c = y.c_view();
  const std::uint64_t fit = (usual_longest - samples_head) / (8 * static_cast<std::uint64_t>(c.stride));
  return std::min(static_cast<std::uint64_t>(c.capacity - c.size), fit);
}

Clock RemoteSubsystem::initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) {
  tolerance_ = TimeTolerance(t_start);
  time_ = t_start;
  return told([&] {
    const std::int64_t first = y.size();
    initialize_.t_start = t_start;
    initialize_.t_stop = t_stop;
    initialize_.room = room(y);
    initialize_.u0.assign(u0.begin(), u0.end());
    begin(Type::initialize);
    put_initialize(frame_, initialize_);
    const Clock clock = read_samples(exchange(Type::samples, &y).payload, y);
    check_first({info_, y, first, clock}, t_start, u0);
    return clock;
  });
}

Clock RemoteSubsystem::advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) {
  start_advance(t_limit, land, u, y);
  return finish_advance(y);
}

bool RemoteSubsystem::start_advance(double t_limit, bool land, std::span<const Signal> u, const Samples& y) {
  goal_ = t_limit;
  told([&] {
    begin(Type::advance);
    put_advance(frame_, {t_limit, land, room(y)}, u, info_.abilities.reactive_inputs);
    send();
  });
  return true;
}

Clock RemoteSubsystem::finish_advance(Samples& y) {
  const Clock clock = told([&] {
    const std::int64_t first = y.size();
    const Clock reply = read_samples(receive(Type::samples, &y).payload, y);
    check_rows({info_, y, first, reply}, {time_, goal_}, tolerance_);
    return reply;
  });
  time_ = clock.time;
  return clock;
}

Clock RemoteSubsystem::sample(double t, SamplePart part, std::span<const double> u, std::span<double> y) {
  if (!info_.abilities.sampled) return Subsystem::sample(t, part, u, y);
  time_ = t;
  return told([&] {
    begin(Type::sample);
    put_sample(frame_, t, part, u);
    const bool gives = part != SamplePart::states;
    const std::span<double> outputs = gives ? y : y.first(0);
    const Clock reply = read_sampled(exchange(Type::sample).payload, outputs);
    check_sample(info_, outputs, t);
    if (part != SamplePart::outputs) check_next_instant(reply, t);
    return reply;
  });
}

void RemoteSubsystem::require_saving() const {
  if (!info_.abilities.saves_state)
    throw Error(ErrorCode::not_supported, "subsystem '" + info_.name + "' has no ability to save its state");
}

StateId RemoteSubsystem::save_state() {
  require_saving();
  return told([&] {
    begin(Type::save);
    return read_id(exchange(Type::save).payload);
  });
}

Clock RemoteSubsystem::restore_state(StateId id) {
  require_saving();
  const Clock clock = told([&] {
    begin(Type::restore);
    put_id(frame_, id);
    const Clock reply = read_clock(exchange(Type::restore).payload);
    check_clock(info_, reply);
    return reply;
  });
  time_ = clock.time;
  return clock;
}

void RemoteSubsystem::release_state(StateId id) {
  require_saving();
  told([&] {
    begin(Type::release);
    put_id(frame_, id);
    read_nothing(exchange(Type::release));
  });
}

void RemoteSubsystem::require_serializing() const {
  if (!info_.abilities.serializes_state)
    throw Error(ErrorCode::not_supported,
                "subsystem '" + info_.name + "' has no ability to give its state as bytes");
}

std::vector<std::byte> RemoteSubsystem::serialize_state(StateId id) {
  require_serializing();
  return told([&] {
    begin(Type::serialize);
    put_id(frame_, id);
    const auto bytes = exchange(Type::serialize).payload;
    return std::vector<std::byte>(bytes.begin(), bytes.end());
  });
}

StateId RemoteSubsystem::deserialize_state(std::span<const std::byte> bytes) {
  require_serializing();
  return told([&] {
    begin(Type::deserialize);
    frame_.put_bytes(bytes);
    return read_id(exchange(Type::deserialize).payload);
  });
}

}  // namespace tandem::wire
