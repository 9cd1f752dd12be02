// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/wire/messages.hpp"

#include <cmath>
#include <cstring>

#include "tandem/check_info.hpp"
#include "tandem/printable.hpp"

namespace tandem::wire {
namespace {

constexpr char magic[] = {'T', 'A', 'N', 'D', 'E', 'M', '\r', '\n'};
constexpr std::uint32_t longest_name = 4096, longest_sentence = 1U << 20;  // bytes
constexpr std::size_t longest_told = 4000;                                 // bytes of a sentence of ours

/// A name or a unit, to be shown.
std::string read_name(Reader& in) { return printable(in.take_text(longest_name), longest_name); }

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

void check_inputs(const Reader& in, std::uint64_t found, int inputs) {
  if (found != static_cast<std::uint64_t>(inputs))
    in.refuse("has " + std::to_string(found) + " inputs; allowed are " + std::to_string(inputs));
}

void check_finite(const Reader& in, double value, const char* what) {
  if (!std::isfinite(value)) in.refuse(std::string("has ") + what + " that is not finite");
}

Segment read_segment(Reader& in, std::uint32_t degree) {
  Segment s = {};
  s.end = in.take<double>();
  s.origin = in.take<double>();
  in.take_doubles({s.c, degree + 1});
  bool sound = !std::isnan(s.end) && std::isfinite(s.origin);
  for (const double c : s.c) sound = sound && std::isfinite(c);
  if (!sound) in.refuse("has an input that is not finite");
  return s;
}

struct SignalHead {
  std::uint32_t count, degree;
  std::size_t segment_size() const { return 8 * (degree + std::size_t{3}); }
};

SignalHead read_signal_head(Reader& in) {
  const auto count = in.take<std::uint32_t>(), degree = in.take<std::uint32_t>();
  if (count == 0 || degree >= TANDEM_MAX_COEFFICIENTS || count > in.left() / (8 * (degree + 3)))
    in.refuse("has an input of " + std::to_string(count) + " segments of degree " + std::to_string(degree) +
              "; allowed are 1 or more that follow, of degree 0 to 5");
  return {count, degree};
}

/// Of all signals, which may take no more memory than the longest request.
std::size_t count_segments(Reader in, int inputs, std::uint64_t most) {
  std::uint64_t all = 0;
  for (int i = 0; i < inputs; ++i) {
    const SignalHead head = read_signal_head(in);
    in.take_bytes(head.count * head.segment_size());
    all += head.count;
  }
  if (all * sizeof(Segment) + static_cast<std::uint64_t>(inputs) * sizeof(Signal) > most)
    in.refuse("has " + std::to_string(inputs) + " inputs of " + std::to_string(all) +
              " segments, which take more than " + std::to_string(most) + " bytes");
  return all;
}

/// Adds the segments to the list, and views them there.
Signal read_signal(Reader& in, std::vector<Segment>& segments) {
  const auto [count, degree] = read_signal_head(in);
  const std::size_t first = segments.size();
  for (std::uint32_t k = 0; k < count; ++k) segments.push_back(read_segment(in, degree));
  return {segments.data() + first, static_cast<std::int32_t>(count), static_cast<std::int32_t>(degree)};
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

}  // namespace

void put_hello(Writer& frame, const Hello& hello) {
  frame.put_bytes(std::as_bytes(std::span(magic)));
  frame.put(hello.lowest_version);
  frame.put(hello.highest_version);
  frame.put(hello.longest);
  frame.put(hello.capabilities);
  frame.put_text(hello.text);
}

Hello read_hello(std::span<const std::byte> payload) {
  Reader in(payload, "hello");
  for (const char c : magic)
    if (in.take<char>() != c) in.refuse("does not begin with TANDEM, so the peer speaks something else");
  Hello hello;
  hello.lowest_version = in.take<std::uint32_t>();
  hello.highest_version = in.take<std::uint32_t>();
  hello.longest = in.take<std::uint64_t>();
  hello.capabilities = in.take<std::uint32_t>();
  hello.text = in.take_text(longest_sentence);
  in.end();
  return hello;
}

void put_info(Writer& frame, const SubsystemInfo& info) {
  frame.put_text(info.name);
  frame.put(to_bits(info.abilities));
  put_ports(frame, info.inputs);
  put_ports(frame, info.outputs);
  frame.put(static_cast<std::uint32_t>(info.feedthrough.size()));
  for (const Feedthrough& f : info.feedthrough) {
    frame.put(std::int32_t{f.output});
    frame.put(std::int32_t{f.input});
  }
}

SubsystemInfo read_info(std::span<const std::byte> payload) {
  Reader in(payload, "info");
  SubsystemInfo info;
  info.name = read_name(in);
  info.abilities = abilities_from(in.take<std::uint32_t>());
  info.inputs = read_ports(in);
  info.outputs = read_ports(in);
  const std::uint64_t count = in.take_count(8);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto output = in.take<std::int32_t>();
    info.feedthrough.push_back({output, in.take<std::int32_t>()});
  }
  in.end();
  check_info(info.name, info);
  return info;
}

void put_initialize(Writer& frame, const Initialize& request) {
  frame.put(request.t_start);
  frame.put(request.t_stop);
  frame.put(request.room);
  frame.put(static_cast<std::uint32_t>(request.u0.size()));
  frame.put_doubles(request.u0);
}

void read_initialize(std::span<const std::byte> payload, int inputs, Initialize& request) {
  Reader in(payload, "initialize");
  request.t_start = in.take<double>();
  request.t_stop = in.take<double>();
  check_finite(in, request.t_start, "a t_start");
  check_finite(in, request.t_stop, "a t_stop");
  request.room = in.take<std::uint64_t>();
  check_inputs(in, in.take_count(sizeof(double)), inputs);
  request.u0.resize(static_cast<std::size_t>(inputs));
  in.take_doubles(request.u0);
  in.end();
}

void put_advance(Writer& frame, const Goal& goal, std::span<const Signal> inputs) {
  frame.put(goal.t_limit);
  frame.put(std::uint32_t{goal.land ? 1U : 0U});
  frame.put(static_cast<std::uint32_t>(inputs.size()));
  frame.put(goal.room);
  for (const Signal& u : inputs) {
    const auto coefficients = static_cast<std::size_t>(u.degree()) + 1;
    frame.put(static_cast<std::uint32_t>(u.segments().size()));
    frame.put(static_cast<std::uint32_t>(u.degree()));
    for (const Segment& s : u.segments()) {
      frame.put(s.end);
      frame.put(s.origin);
      frame.put_doubles({s.c, coefficients});
    }
  }
}

void read_advance(std::span<const std::byte> payload, int inputs, Advance& request, std::uint64_t most) {
  Reader in(payload, "advance");
  request.t_limit = in.take<double>();
  check_finite(in, request.t_limit, "a t_limit");
  const auto land = in.take<std::uint32_t>();
  if (land > 1) in.refuse("has " + std::to_string(land) + " for land; allowed are 0 and 1");
  request.land = land == 1;
  check_inputs(in, in.take_count(8), inputs);
  request.room = in.take<std::uint64_t>();
  request.segments.clear();
  request.segments.reserve(count_segments(in, inputs, most));  // so that it stands still under the signals
  request.signals.clear();
  request.signals.reserve(static_cast<std::size_t>(inputs));
  for (int i = 0; i < inputs; ++i) request.signals.push_back(read_signal(in, request.segments));
  in.end();
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

Error read_error(std::span<const std::byte> payload, Samples* y) {
  Reader in(payload, "error");
  const ErrorCode code = code_from(in.take<std::uint32_t>());
  const std::string sentence = printable(in.take_text(longest_sentence));
  if (y && in.left() > 0) read_rows(in, *y);
  in.end();
  return {code, sentence};
}

void read_nothing(const Frame& frame) { Reader(frame.payload, name(frame.header.type)).end(); }

}  // namespace tandem::wire
