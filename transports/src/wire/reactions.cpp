// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Inputs that react (tandem/reaction.h), behind the signals of a request to advance.
#include <algorithm>
#include <cmath>

#include "tandem/wire/messages.hpp"

namespace tandem::wire {
namespace {

std::size_t size(std::int32_t count) { return static_cast<std::size_t>(count); }

/// Of the matrices and the states, of n states by p outputs.
std::size_t count_numbers(std::size_t n, std::size_t p) { return n * (n + 2 * p + 5); }

void take_finite(Reader& in, std::span<double> numbers) {
  in.take_doubles(numbers);
  if (std::any_of(numbers.begin(), numbers.end(), [](double one) { return !std::isfinite(one); }))
    in.refuse("has a reaction that is not finite");
}

std::int32_t take_index(Reader& in, const char* what, int scalars) {
  const auto index = in.take<std::int32_t>();
  if (index < 0 || index >= scalars)
    in.refuse("has a reaction by the " + std::string(what) + " " + std::to_string(index) +
              "; allowed are 0 to " + std::to_string(scalars - 1));
  return index;
}

/// The rows stand still under the inputs.
void read_inputs(Reader& in, const Scalars& scalars, std::size_t states, Advance& to) {
  const std::uint64_t count = in.take_count(4 + 8 * states);
  if (count == 0 || count > to.signals.size())
    in.refuse("has a reaction of " + std::to_string(count) + " inputs; allowed are 1 to " +
              std::to_string(to.signals.size()));
  to.reaction.rows.resize(count * states);
  to.reaction.inputs.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    Signal& signal = to.signals[size(take_index(in, "input", scalars.inputs))];
    if (signal.reactive()) in.refuse("has a reaction of one input twice");
    const std::span row = std::span(to.reaction.rows).subspan(k * states, states);
    take_finite(in, row);
    to.reaction.inputs[k] = {&to.reaction.view, row.data()};
    signal = signal.with(&to.reaction.inputs[k]);
  }
}

}  // namespace

void put_reaction(Writer& frame, std::span<const Signal> u) {
  const Reaction* const r = reaction_of(u);
  frame.put(r ? static_cast<std::uint32_t>(r->states) : 0U);
  if (!r) return;
  const std::size_t n = size(r->states), p = size(r->outputs);
  frame.put(r->origin);
  frame.put(static_cast<std::uint32_t>(p));
  for (std::size_t k = 0; k < p; ++k) frame.put(r->output[k]);
  for (const auto& [numbers, count] :
       {std::pair{r->a, n * n}, {r->b0, n * p}, {r->b1, n * p}, {r->c, 4 * n}, {r->begin, n}})
    frame.put_doubles({numbers, count});
  frame.put(static_cast<std::uint32_t>(
      std::count_if(u.begin(), u.end(), [](const Signal& one) { return one.reactive() != nullptr; })));
  for (std::size_t k = 0; k < u.size(); ++k) {
    if (!u[k].reactive()) continue;
    frame.put(static_cast<std::int32_t>(k));
    frame.put_doubles({u[k].reactive()->row, n});
  }
}

void read_reaction(Reader& in, const Scalars& scalars, Advance& to) {
  const std::uint32_t n = in.take<std::uint32_t>();
  const auto most = 6 * static_cast<std::uint64_t>(std::min(scalars.inputs, scalars.outputs));
  if (n > most)
    in.refuse("has a reaction of " + std::to_string(n) + " states; allowed are up to " +
              std::to_string(most));
  to.reaction.view.states = static_cast<std::int32_t>(n);
  if (n == 0) return;
  Reaction& r = to.reaction.view;
  r.origin = in.take<double>();
  if (!std::isfinite(r.origin)) in.refuse("has a reaction that is not finite");
  const std::uint64_t p = in.take_count(4);
  if (p > static_cast<std::uint64_t>(scalars.outputs))
    in.refuse("has a reaction by " + std::to_string(p) + " outputs; allowed are up to " +
              std::to_string(scalars.outputs));
  to.reaction.outputs.resize(p);
  for (std::int32_t& one : to.reaction.outputs) one = take_index(in, "output", scalars.outputs);
  if (in.left() / 8 < count_numbers(n, p)) in.refuse("has a reaction that is longer than it");
  to.reaction.numbers.resize(count_numbers(n, p));
  take_finite(in, to.reaction.numbers);
  r.outputs = static_cast<std::int32_t>(p), r.output = to.reaction.outputs.data();
  r.a = to.reaction.numbers.data(), r.b0 = r.a + n * n, r.b1 = r.b0 + n * p, r.c = r.b1 + n * p,
  r.begin = r.c + 4 * std::size_t{n};
  read_inputs(in, scalars, n, to);
}

}  // namespace tandem::wire
