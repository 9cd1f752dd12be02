// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/wire/messages.hpp"

#include <cstring>

#include "declared.hpp"
#include "tandem/check_info.hpp"
#include "tandem/printable.hpp"

namespace tandem::wire {
namespace {

constexpr char magic[] = {'T', 'A', 'N', 'D', 'E', 'M', '\r', '\n'};
constexpr std::uint32_t longest_sentence = 1U << 20;  // bytes
constexpr std::size_t longest_told = 4000;            // bytes of a sentence of ours

Port read_port(Reader& in) {
  Port port;
  port.name = read_name(in);
  port.unit = read_name(in);
  port.size = in.take<std::int32_t>();
  port.derivatives = in.take<std::int32_t>();
  port.start = in.take<double>();
  return port;
}

std::vector<Port> read_ports(Reader& in) {
  const std::uint64_t count = in.take_count(24);
  std::vector<Port> ports;
  ports.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) ports.push_back(read_port(in));
  return ports;
}

void put_ports(Writer& frame, const std::vector<Port>& ports) {
  frame.put(static_cast<std::uint32_t>(ports.size()));
  for (const Port& port : ports) {
    frame.put_text(port.name);
    frame.put_text(port.unit);
    frame.put(std::int32_t{port.size});
    frame.put(std::int32_t{port.derivatives});
    frame.put(port.start);
  }
}

/// What stands behind the rest of an info only where there are held outputs.
void put_held(Writer& frame, const SubsystemInfo& info) {
  if (info.holds())
    for (const Port& port : info.outputs) frame.put(std::uint32_t{port.held ? 1U : 0U});
  if (!info.abilities.sampled) return;
  frame.put(info.sampling.period);
  frame.put(info.sampling.latency);
}

/// told: a flag for each output stands there. Those of a sampled subsystem are held in any case.
void read_held(Reader& in, bool told, SubsystemInfo& info) {
  for (Port& port : info.outputs) {
    const std::uint32_t held = told ? in.take<std::uint32_t>() : info.abilities.sampled ? 1 : 0;
    if (held > 1)
      in.refuse("gives " + std::to_string(held) + " for whether output '" + port.name +
                "' is held; allowed are 0 and 1");
    port.held = held == 1;
  }
}

void read_sampling(Reader& in, Sampling& sampling) {
  sampling.period = in.take<double>();
  sampling.latency = in.take<double>();
}

Clock read_clock(Reader& in) {
  Clock clock{};
  clock.time = in.take<double>();
  clock.next_time = in.take<double>();
  const auto stop = in.take<std::uint32_t>();
  if (stop > TANDEM_STOP_FINISHED)
    in.refuse("gives " + std::to_string(stop) + " as the reason to stop; allowed are 0 to 3");
  clock.stop = static_cast<Stop>(stop);
  return clock;
}

/// Puts a head of so many bytes and the rows behind it, which are moved there first if they stand elsewhere.
template <class PutHead>
void put_with_rows(Writer& frame, std::size_t head, const Samples& y, const PutHead& put_head) {
  const tandem_samples c = y.c_view();
  const std::span<double> rows(c.rows, static_cast<std::size_t>(c.size * c.stride));
  if constexpr (std::endian::native == std::endian::big)
    for (double& value : rows) value = std::bit_cast<double>(to_wire(value));
  std::byte* const place = frame.room(frame.size() + head, rows.size_bytes());
  if (!rows.empty()) std::memmove(place, rows.data(), rows.size_bytes());
  put_head();
  frame.put(static_cast<std::uint32_t>(c.stride));
  frame.put(static_cast<std::uint64_t>(c.size));
  frame.put_filled(rows.size_bytes());
}

void read_rows(Reader& in, Samples& y) {
  const tandem_samples c = y.c_view();
  const auto stride = in.take<std::uint32_t>();
  const auto rows = in.take<std::uint64_t>();
  if (rows > 0 && stride != c.stride)
    in.refuse("has rows of " + std::to_string(stride) + " numbers; allowed are " + std::to_string(c.stride));
  if (rows > static_cast<std::uint64_t>(c.capacity - c.size))
    in.refuse("has " + std::to_string(rows) + " rows; allowed are up to " +
              std::to_string(c.capacity - c.size));
  in.take_doubles({c.rows + c.size * c.stride, static_cast<std::size_t>(rows) * stride});
  in.end();
  y.set_size(c.size + static_cast<std::int64_t>(rows));
}

ErrorCode code_from(std::uint32_t code) {
  const bool known = code >= TANDEM_INVALID_ARGUMENT && code <= TANDEM_INTERNAL;
  return known ? static_cast<ErrorCode>(code) : ErrorCode::internal;
}

Error read_error(Reader& in) {
  const ErrorCode code = code_from(in.take<std::uint32_t>());
  return {code, printable(in.take_text(longest_sentence))};
}

}  // namespace

void put_hello(Writer& frame, const Hello& hello) {
  frame.put_bytes(std::as_bytes(std::span(magic)));
  frame.put(hello.lowest_version);
  frame.put(hello.highest_version);
  frame.put(hello.longest);
  frame.put(hello.capabilities);
  frame.put_text(hello.text);
  if (hello.declared) put_declared(frame, *hello.declared);
}

Hello read_hello(std::span<const std::byte> payload, std::uint32_t asked_with) {
  Reader in(payload, "hello");
  for (const char c : magic)
    if (in.take<char>() != c) in.refuse("does not begin with TANDEM, so the peer speaks something else");
  Hello hello;
  hello.lowest_version = in.take<std::uint32_t>();
  hello.highest_version = in.take<std::uint32_t>();
  hello.longest = in.take<std::uint64_t>();
  hello.capabilities = in.take<std::uint32_t>();
  hello.text = in.take_text(longest_sentence);
  if (hello.capabilities & asked_with & carries_parameters) hello.declared = read_declared(in);
  in.end();
  return hello;
}

void put_info(Writer& frame, const SubsystemInfo& info, std::uint32_t capabilities) {
  frame.put_text(info.name);
  frame.put(to_bits(info));
  put_ports(frame, info.inputs);
  put_ports(frame, info.outputs);
  frame.put(static_cast<std::uint32_t>(info.feedthrough.size()));
  for (const Feedthrough& f : info.feedthrough) {
    frame.put(std::int32_t{f.output});
    frame.put(std::int32_t{f.input});
  }
  put_held(frame, info);
  if (capabilities & carries_nominal)
    for (const Port& port : info.outputs) frame.put(port.nominal);
}

SubsystemInfo read_info(std::span<const std::byte> payload, std::uint32_t capabilities) {
  Reader in(payload, "info");
  SubsystemInfo info;
  info.name = read_name(in);
  const auto bits = in.take<std::uint32_t>();
  info.abilities = abilities_from(bits);
  info.inputs = read_ports(in);
  info.outputs = read_ports(in);
  const std::uint64_t count = in.take_count(8);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto output = in.take<std::int32_t>();
    info.feedthrough.push_back({output, in.take<std::int32_t>()});
  }
  read_held(in, (bits & TANDEM_HOLDS) != 0, info);
  if (info.abilities.sampled) read_sampling(in, info.sampling);
  if (capabilities & carries_nominal)
    for (Port& port : info.outputs) port.nominal = in.take<double>();
  in.end();
  check_info(info.name, info);
  return info;
}

Samples room_for_rows(Writer& frame, std::int64_t stride, std::int64_t capacity) {
  const auto numbers = static_cast<std::size_t>(stride * capacity);
  const std::size_t spare = samples_head + longest_told + 3;  // an error's head is longer
  std::byte* const head = frame.room(frame.size(), spare + sizeof(double) * numbers);
  return {reinterpret_cast<double*>(head + samples_head), stride, capacity};
}

void put_samples(Writer& frame, const Clock& clock, const Samples& y) {
  put_with_rows(frame, samples_head, y, [&] { put_clock(frame, clock); });
}

Clock read_samples(std::span<const std::byte> payload, Samples& y) {
  Reader in(payload, "samples");
  const Clock clock = read_clock(in);
  read_rows(in, y);
  return clock;
}

void put_clock(Writer& frame, const Clock& clock) {
  frame.put(clock.time);
  frame.put(clock.next_time);
  frame.put(static_cast<std::uint32_t>(clock.stop));
}

Clock read_clock(std::span<const std::byte> payload) {
  Reader in(payload, "restore");
  const Clock clock = read_clock(in);
  in.end();
  return clock;
}

void put_sampled(Writer& frame, const Clock& clock, std::span<const double> y) {
  put_clock(frame, clock);
  frame.put_list(y);
}

Clock read_sampled(std::span<const std::byte> payload, std::span<double> y) {
  Reader in(payload, "sample");
  const Clock clock = read_clock(in);
  in.take_list(y);
  in.end();
  return clock;
}

void put_id(Writer& frame, StateId id) { frame.put(std::int64_t{id}); }

StateId read_id(std::span<const std::byte> payload) {
  Reader in(payload, "state");
  const auto id = in.take<std::int64_t>();
  in.end();
  return id;
}

void put_error(Writer& frame, ErrorCode code, std::string_view sentence) {
  frame.put(static_cast<std::uint32_t>(code));
  frame.put_text(printable(sentence, longest_told));
}

void put_error(Writer& frame, const Error& error, const Samples& y) {
  const std::size_t head = 20 + printable(error.what(), longest_told).size();
  put_with_rows(frame, head, y, [&] { put_error(frame, error.code(), error.what()); });
}

void put_error(Writer& frame, const NotMade& error) {
  put_error(frame, error.code(), error.what());
  put_declared(frame, error.parameters());
}

Error read_error(std::span<const std::byte> payload, Samples* y) {
  Reader in(payload, "error");
  Error error = read_error(in);
  if (y && in.left() > 0) read_rows(in, *y);
  in.end();
  return error;
}

Error read_error(std::span<const std::byte> payload, DeclaredParameters& declared) {
  Reader in(payload, "error");
  Error error = read_error(in);
  if (in.left() > 0) declared = read_declared(in);
  in.end();
  return error;
}

void read_nothing(const Frame& frame) { Reader(frame.payload, name(frame.header.type)).end(); }

}  // namespace tandem::wire
