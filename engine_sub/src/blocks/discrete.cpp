// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "functions.hpp"
#include "kinds.hpp"

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
  to.start(held, a.wire("initial", 0.0));
  const int event = a.has("period") ? to.periodic(a.positive("period"), a.number("offset", 0.0))
                                    : to.crossing(a.wire("trigger"), Crossing::Direction::rising);
  to.update(event, held, a.wire("input"));
  to.define("", held);
}

/// The input as it was at the sample before the last. In a triggered diagram, which sees what is held before
/// its event: at the event before.
void unit_delay(Lowering& to, Arguments& a) {
  const int last = to.held();
  to.start(last, a.wire("initial", 0.0));
  if (to.scope().trigger >= 0) {
    to.update(to.scope().trigger, last, a.wire("input"));
    return to.define("", last);
  }
  const int before = to.held();
  to.start(before, a.wire("initial", 0.0));
  const int event = to.periodic(a.positive("period"), a.number("offset", 0.0));
  to.update(event, before, last);
  to.update(event, last, a.wire("input"));
  to.define("", before);
}

/// The input as it was at the end of the last own step: what it holds changes where the next one begins.
void memory(Lowering& to, Arguments& a) {
  const int held = to.held();
  to.start(held, a.wire("initial", 0.0));
  to.update(to.own_step(), held, a.wire("input"));
  to.define("", held);
}

/// The input as it was `delay` seconds before; `initial` until there is one.
void transport_delay(Lowering& to, Arguments& a) {
  const double points = a.number("points", 1000.0);
  if (points < 4.0 || points > 1e7 || points != std::floor(points))
    a.refuse("points", fmt::format("{}", points), "a whole number from 4 to 1e7");
  const int input = a.wire("input"), initial = a.wire("initial", 0.0);
  to.define("", to.delay(input, initial, a.positive("delay"), static_cast<int>(points)));
}

/// A signal that rises above 0 where the input passes the next multiple of `every`, and falls below it there
/// and then, as that multiple is the one that has been passed: of several at once, which a jump passes, the
/// last. What is behind it at the start has not been passed.
void passes(Lowering& to, Arguments& a) {
  const double every = a.positive("every");
  const int input = a.wire("input"), count = to.held();
  const int next = to.linear(1.0, 1.0, unary(to, "floor", to.linear(0.0, 1.0 / every, input)));
  to.start(count, larger(to, to.constant(a.number("first", 1.0)), next));
  const int beyond = to.sum({input, count}, {1.0, -every});
  const int event = to.crossing(beyond, Crossing::Direction::rising);
  to.events[event].repeats = true;  // where the input jumps at the instant of another event
  to.update(event, count, larger(to, to.linear(1.0, 1.0, count), next));
  to.define("", beyond);
}

}  // namespace

const std::vector<BlockKind> discrete_blocks = {{"sample", sample},
                                                {"unit_delay", unit_delay},
                                                {"memory", memory},
                                                {"delay", transport_delay},
                                                {"passes", passes}};

}  // namespace tandem::engine
