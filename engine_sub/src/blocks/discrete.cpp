// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "kinds.hpp"
#include "math_functions.hpp"

namespace tandem::engine {
namespace {

int unary(Lowering& to, const char* name, int x) {
  return to.operation(Operation::Code::function, x, number_of(functions, name));
}

int larger(Lowering& to, int x, int y) {
  return to.operation(Operation::Code::function2, x, y, {}, number_of(functions2, "max"));
}

/// The input as it was at the last event: where `trigger` rises above 0, or every `period` from `offset` on.
void sample(Lowering& to, Arguments& a) {
  const int held = to.held();
  to.start(held, a.wire("initial"));
  const int event = a.has("period") ? to.periodic(a.positive("period"), a.number("offset"))
                                    : to.crossing(a.wire("trigger"), Crossing::Direction::rising);
  to.update(event, held, a.wire("input"));
  to.define("", held);
}

/// The input as it was at the sample before the last. In a triggered diagram, which sees what is held before
/// its event: at the event before.
void unit_delay(Lowering& to, Arguments& a) {
  const int last = to.held();
  to.start(last, a.wire("initial"));
  if (to.scope().trigger >= 0) {
    to.update(to.scope().trigger, last, a.wire("input"));
    return to.define("", last);
  }
  const int before = to.held();
  to.start(before, a.wire("initial"));
  const int event = to.periodic(a.positive("period"), a.number("offset"));
  to.update(event, before, last);
  to.update(event, last, a.wire("input"));
  to.define("", before);
}

/// The input as it was at the end of the last own step: what it holds changes where the next one begins.
void memory(Lowering& to, Arguments& a) {
  const int held = to.held();
  to.start(held, a.wire("initial"));
  to.update(to.own_step(), held, a.wire("input"));
  to.define("", held);
}

/// The input as it was `delay` seconds before; `initial` until there is one.
void transport_delay(Lowering& to, Arguments& a) {
  const double points = a.number("points");
  if (points < 4.0 || points > 1e7 || points != std::floor(points))
    a.refuse("points", fmt::format("{}", points), "a whole number from 4 to 1e7");
  const int input = a.wire("input"), initial = a.wire("initial");
  to.define("", to.delay(input, initial, a.positive("delay"), static_cast<int>(points)));
}

/// A signal that rises above 0 where the input passes the next multiple of `every`, and falls below it there
/// and then, as that multiple is the one that has been passed: of several at once, which a jump passes, the
/// last. What is behind it at the start has not been passed.
void passes(Lowering& to, Arguments& a) {
  const double every = a.positive("every");
  const int input = a.wire("input"), count = to.held();
  const int next = to.linear(1.0, 1.0, unary(to, "floor", to.linear(0.0, 1.0 / every, input)));
  to.start(count, larger(to, to.constant(a.number("first")), next));
  const int beyond = to.sum({input, count}, {1.0, -every});
  const int event = to.crossing(beyond, Crossing::Direction::rising);
  to.events[event].repeats = true;  // where the input jumps at the instant of another event
  to.update(event, count, larger(to, to.linear(1.0, 1.0, count), next));
  to.define("", beyond);
}

/// Of what holds an input.
void keys_of_holding(text::KeyList& to) {
  to.need("input", Type::signal, "The signal.")
      .may("initial", Type::signal, "What it is until there is one.", {.otherwise = "0.0"});
}

void keys_of_period(text::KeyList& to, const char* without) {
  to.may("period", Type::positive, without, {.unit = "s"})
      .may("offset", Type::number, "When the first is, from the start of the run.",
           {.unit = "s", .otherwise = "0.0"});
}

}  // namespace

const std::vector<BlockKind> discrete_blocks = {
    {"sample", sample, "A signal as it was at the last sample.",
     [](text::KeyList& to) {
       keys_of_holding(to);
       to.may("trigger", Type::signal, "Where this rises above 0 there is a sample, or");
       keys_of_period(to, "from sample to sample.");
     }},
    {"unit_delay", unit_delay, "A signal as it was at the sample before the last.",
     [](text::KeyList& to) {
       keys_of_holding(to);
       keys_of_period(to,
                      "From sample to sample; in a triggered diagram, whose events they are, there is none.");
     }},
    {"memory", memory, "A signal as it was at the end of the last own step.", keys_of_holding},
    {"delay", transport_delay, "A signal as it was some time before.",
     [](text::KeyList& to) {
       keys_of_holding(to);
       to.need("delay", Type::positive, "How long.", {.unit = "s"})
           .may("points", Type::number, "That it remembers, one a step.",
                {.otherwise = "1000.0", .allowed = "a whole number from 4 to 1e7"});
     }},
    {"passes", passes, "It rises where a signal passes the next multiple of `every`.", [](text::KeyList& to) {
       to.need("input", Type::signal, "The signal.")
           .need("every", Type::positive, "From one to the next.")
           .may("first", Type::number, "The first multiple.", {.otherwise = "1.0"});
     }}};

}  // namespace tandem::engine
