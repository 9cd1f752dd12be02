// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Inputs that react (tandem/reaction.h), behind the signals of a request to advance.
#include <algorithm>
#include <cmath>

#include "tandem/wire/messages.hpp"

namespace tandem::wire {
namespace {

constexpr std::uint64_t term_size = 24, course_size = 40, input_size = 16;  // bytes on the wire

double take_finite(Reader& in) {
  const auto value = in.take<double>();
  if (!std::isfinite(value)) in.refuse("has a reaction that is not finite");
  return value;
}

std::int32_t take_index(Reader& in, const char* what, std::int64_t count) {
  const auto index = in.take<std::int32_t>();
  if (index < 0 || index >= count)
    in.refuse("has a reaction by the " + std::string(what) + " " + std::to_string(index) +
              "; allowed are 0 to " + std::to_string(count - 1));
  return index;
}

void read_terms(Reader& in, const Scalars& scalars, ReadReaction& to) {
  const auto n = static_cast<std::int64_t>(to.begin.size());
  to.terms.resize(in.take_count(term_size));
  for (tandem_reaction_term& one : to.terms) {
    one.to = take_index(in, "state", n), one.from = take_index(in, "state or output", n + scalars.outputs);
    one.factor = take_finite(in), one.rate = take_finite(in);
  }
  to.courses.resize(in.take_count(course_size));
  for (tandem_reaction_course& one : to.courses) {
    one.to = take_index(in, "state", n), one.reserved = in.take<std::int32_t>();
    for (double& c : one.c) c = take_finite(in);
  }
}

/// They stand still under the signals.
void read_inputs(Reader& in, Advance& to) {
  const std::uint64_t count = in.take_count(input_size);
  if (count == 0 || count > to.signals.size())
    in.refuse("has a reaction of " + std::to_string(count) + " inputs; allowed are 1 to " +
              std::to_string(to.signals.size()));
  to.reaction.inputs.resize(count);
  for (tandem_reactive_input& one : to.reaction.inputs) {
    Signal& signal = to.signals[static_cast<std::size_t>(take_index(in, "input", std::ssize(to.signals)))];
    if (signal.reactive()) in.refuse("has a reaction of one input twice");
    one.reaction = &to.reaction.view;
    one.state = take_index(in, "state", std::ssize(to.reaction.begin)), one.gain = take_finite(in);
    signal = signal.with(&one);
  }
}

}  // namespace

void put_reaction(Writer& frame, std::span<const Signal> u) {
  const Reaction* const r = reaction_of(u);
  frame.put(r ? static_cast<std::uint32_t>(r->states) : 0U);
  if (!r) return;
  frame.put(r->origin);
  frame.put_doubles({r->begin, static_cast<std::size_t>(r->states)});
  frame.put(static_cast<std::uint32_t>(r->terms));
  for (const tandem_reaction_term& one : std::span(r->term, static_cast<std::size_t>(r->terms)))
    frame.put(one.to), frame.put(one.from), frame.put(one.factor), frame.put(one.rate);
  frame.put(static_cast<std::uint32_t>(r->courses));
  for (const tandem_reaction_course& one : std::span(r->course, static_cast<std::size_t>(r->courses)))
    frame.put(one.to), frame.put(one.reserved), frame.put_doubles(one.c);
  frame.put(static_cast<std::uint32_t>(
      std::count_if(u.begin(), u.end(), [](const Signal& one) { return one.reactive() != nullptr; })));
  for (std::size_t k = 0; k < u.size(); ++k)
    if (const tandem_reactive_input* one = u[k].reactive())
      frame.put(static_cast<std::int32_t>(k)), frame.put(one->state), frame.put(one->gain);
}

void read_reaction(Reader& in, const Scalars& scalars, Advance& to) {
  const auto n = in.take<std::uint32_t>();
  const auto most = 6 * static_cast<std::uint64_t>(std::min(scalars.inputs, scalars.outputs));
  if (n > most)
    in.refuse("has a reaction of " + std::to_string(n) + " states; allowed are up to " +
              std::to_string(most));
  ReadReaction& read = to.reaction;
  read.view.states = static_cast<std::int32_t>(n);
  if (n == 0) return;
  read.view.origin = take_finite(in);
  if (n > in.left() / sizeof(double)) in.refuse("has a reaction that is longer than it");
  read.begin.resize(n);
  for (double& one : read.begin) one = take_finite(in);
  read_terms(in, scalars, read);
  read.view = {read.view.states,
               static_cast<std::int32_t>(read.terms.size()),
               static_cast<std::int32_t>(read.courses.size()),
               read.view.origin,
               read.terms.data(),
               read.courses.data(),
               read.begin.data()};
  read_inputs(in, to);
}

}  // namespace tandem::wire
