// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Payloads of the requests that move a subsystem.
#include <algorithm>
#include <cmath>

#include "tandem/wire/messages.hpp"

namespace tandem::wire {
namespace {

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
  const SignalHead head{count, degree};
  if (count == 0 || degree >= TANDEM_MAX_COEFFICIENTS || count > in.left() / head.segment_size())
    in.refuse("has an input of " + std::to_string(count) + " segments of degree " + std::to_string(degree) +
              "; allowed are 1 or more that follow, of degree 0 to 5");
  return head;
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

}  // namespace

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

/// The mark of a jump stands in the last coefficient.
static std::uint32_t degree_to_send(const Signal& u) {
  const bool jumps = std::any_of(u.segments().begin(), u.segments().end(),
                                 [](const Segment& s) { return tandem_segment_jumps(&s) != 0; });
  return jumps ? TANDEM_MAX_COEFFICIENTS - 1 : static_cast<std::uint32_t>(u.degree());
}

void put_advance(Writer& frame, const Goal& goal, std::span<const Signal> inputs, bool react) {
  frame.put(goal.t_limit);
  frame.put(std::uint32_t{goal.land ? 1U : 0U});
  frame.put(static_cast<std::uint32_t>(inputs.size()));
  frame.put(goal.room);
  for (const Signal& u : inputs) {
    const std::uint32_t degree = degree_to_send(u);
    frame.put(static_cast<std::uint32_t>(u.segments().size()));
    frame.put(degree);
    for (const Segment& s : u.segments()) {
      frame.put(s.end);
      frame.put(s.origin);
      frame.put_doubles({s.c, degree + std::size_t{1}});
    }
  }
  if (react) put_reaction(frame, inputs);
}

void read_advance(std::span<const std::byte> payload, const Scalars& scalars, Advance& request,
                  std::uint64_t most) {
  const int inputs = scalars.inputs;
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
  request.reaction.view.states = 0;
  if (scalars.react) read_reaction(in, scalars, request);
  in.end();
}

void put_sample(Writer& frame, double t, SamplePart part, std::span<const double> u) {
  frame.put(t);
  frame.put(static_cast<std::uint32_t>(part));
  frame.put_list(u);
}

void read_sample(std::span<const std::byte> payload, int inputs, Sample& request) {
  Reader in(payload, "sample");
  request.t = in.take<double>();
  check_finite(in, request.t, "a t");
  const auto parts = in.take<std::uint32_t>();
  if (parts < 1 || parts > 3)
    in.refuse("asks for the parts " + std::to_string(parts) + "; allowed are 1 to 3");
  request.part = static_cast<SamplePart>(parts);
  check_inputs(in, in.take_count(sizeof(double)), inputs);
  request.u.resize(static_cast<std::size_t>(inputs));
  in.take_doubles(request.u);
  for (const double u : request.u) check_finite(in, u, "an input");
  in.end();
}

}  // namespace tandem::wire
