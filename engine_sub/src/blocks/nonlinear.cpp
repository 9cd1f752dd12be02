// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "kinds.hpp"

namespace tandem::engine {
namespace {

using Code = Operation::Code;

/// Limits `low` and `high` of a block.
std::vector<double> limits(Arguments& a) {
  const double low = a.number("low"), high = a.number("high");
  if (!(low < high)) a.refuse("low", fmt::format("{}", low), fmt::format("below high, {}", high));
  return {low, high};
}

/// -1, 0, 1: on which side of the limits a signal is, as of the last event.
int side(Lowering& to, int signal, const std::vector<double>& limits) {
  const int wanted = to.operation(Code::beyond, signal, 0, limits);
  return to.mode(wanted, {to.linear(-limits[0], 1.0, signal), to.linear(-limits[1], 1.0, signal)});
}

void limited(Lowering& to, Arguments& a, Code code) {
  const int input = a.wire("input");
  const auto between = limits(a);
  to.define("", to.operation(code, input, 0, between, side(to, input, between)));
}

void saturation(Lowering& to, Arguments& a) { limited(to, a, Code::clamp); }
void dead_zone(Lowering& to, Arguments& a) { limited(to, a, Code::dead_zone); }

/// `on` from where the input rises above `high`, `off` from where it falls below `low`; at the start, between
/// these, as `starts_on` says.
void relay(Lowering& to, Arguments& a) {
  const int input = a.wire("input");
  const auto between = limits(a);
  const int on = to.constant(a.number("on")), off = to.constant(a.number("off"));
  const int state = to.held(), between_them = to.constant(a.flag("starts_on") ? 1.0 : 0.0);
  to.start(state, to.operation(Code::clamp, between_them, 0, {0.0, 1.0},
                               to.operation(Code::beyond, input, 0, between)));
  const int rises = to.crossing(to.linear(-between[1], 1.0, input), Crossing::Direction::rising);
  to.update(rises, state, to.constant(1.0));
  const int falls = to.crossing(to.linear(-between[0], 1.0, input), Crossing::Direction::falling);
  to.update(falls, state, to.constant(0.0));
  to.define("", to.operation(Code::select, on, off, {}, state));
}

/// `above` where the control is above the threshold, else `below`.
void switch_over(Lowering& to, Arguments& a) {
  const double threshold = a.number("threshold");
  const int control = to.linear(-threshold, 1.0, a.wire("control"));
  const int above = a.wire("above"), below = a.wire("below");
  const int mode = to.mode(to.operation(Code::compare, control, to.constant(0.0)), {control});
  to.define("", to.operation(Code::select, above, below, {}, mode));
}

void keys_of_limited(text::KeyList& to) {
  to.need("input", Type::signal, "The signal.")
      .need("low", Type::number, "The lower limit.")
      .need("high", Type::number, "The upper limit.");
}

}  // namespace

const std::vector<BlockKind> nonlinear_blocks = {
    {"saturation", saturation, "A signal within limits.", keys_of_limited},
    {"dead_zone", dead_zone, "How far a signal is beyond its limits.", keys_of_limited},
    {"relay", relay, "`on` from where a signal rises above `high`, `off` from where it falls below `low`.",
     [](text::KeyList& to) {
       keys_of_limited(to);
       to.may("on", Type::number, "The one value.", {.otherwise = "1.0"})
           .may("off", Type::number, "The other value.", {.otherwise = "0.0"})
           .may("starts_on", Type::flag, "At the start, between the limits, it is on.",
                {.otherwise = "false"});
     }},
    {"switch", switch_over, "`above` where a signal is above the threshold, else `below`.",
     [](text::KeyList& to) {
       to.need("control", Type::signal, "The signal.")
           .need("above", Type::signal, "The one.")
           .need("below", Type::signal, "The other.")
           .may("threshold", Type::number, "Of the control.", {.otherwise = "0.0"});
     }}};

}  // namespace tandem::engine
