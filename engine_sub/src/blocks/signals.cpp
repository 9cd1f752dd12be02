// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "data.hpp"
#include "kinds.hpp"
#include "made.hpp"
#include "tandem/text/series.hpp"

namespace tandem::engine {
namespace {

using Code = Operation::Code;

void constant(Lowering& to, Arguments& a) { to.define("", to.constant(a.number("value"))); }

/// before, until `time`, where there is an event; then after.
void step(Lowering& to, Arguments& a) {
  const double t = a.number("time");
  const int before = to.constant(a.number("before")), level = to.constant(a.number("after"));
  const int wanted = to.operation(Code::compare, to.time(), to.constant(t));
  const int after = to.mode(wanted, {to.linear(-t, 1.0, to.time())});
  to.define("", to.operation(Code::select, level, before, {}, after));
}

/// start + slope (t - time) from `time` on.
void ramp(Lowering& to, Arguments& a) {
  const int since = to.linear(-a.number("time"), 1.0, to.time());
  const std::vector<double> limits = {0.0, std::numeric_limits<double>::infinity()};
  const int mode = to.mode(to.operation(Code::beyond, since, 0, limits), {since});
  to.define(
      "", to.linear(a.number("start"), a.number("slope"), to.operation(Code::clamp, since, 0, limits, mode)));
}

/// mean + amplitude sin(2 pi frequency t + phase).
void sine(Lowering& to, Arguments& a) {
  const double turn = 2.0 * std::numbers::pi * a.positive("frequency");
  const int angle = to.linear(a.number("phase"), turn, to.time());
  const int wave = to.operation(Code::function, angle, 0);
  to.define("", to.linear(a.number("mean"), a.number("amplitude"), wave));
}

/// Values at their key must be within `low` and `high`, if these are given.
void check_values(Arguments& a, const std::vector<double>& values) {
  const double low = a.number("low"), high = a.number("high");
  for (const double value : values)
    if (!(value >= low && value <= high))
      a.refuse("values", fmt::format("an array with {}", value), fmt::format("{} to {}", low, high));
}

/// Values at points of time.
void piecewise_linear(Lowering& to, Arguments& a) {
  const auto values = a.numbers("values");
  check_values(a, values);
  const auto how = joining(a);
  define_data(to, a, made(a, [&] { return TimeSeries(a.owner(), a.numbers("times"), values, how); }));
}

}  // namespace

const std::vector<BlockKind> source_blocks = {
    {"constant", constant, "A number.",
     [](text::KeyList& to) { to.need("value", Type::number, "The number."); }},
    {"step", step, "A number that changes once, where there is an event.",
     [](text::KeyList& to) {
       to.need("time", Type::number, "When.", {.unit = "s"})
           .need("after", Type::number, "What it is from then on.")
           .may("before", Type::number, "What it is until then.", {.otherwise = "0.0"});
     }},
    {"ramp", ramp, "start + slope (t - time) from `time` on, and `start` before.",
     [](text::KeyList& to) {
       to.need("slope", Type::number, "Of the output, by time.")
           .may("time", Type::number, "When it begins.", {.unit = "s", .otherwise = "0.0"})
           .may("start", Type::number, "What it is until then.", {.otherwise = "0.0"});
     }},
    {"sine", sine, "mean + amplitude sin(2 pi frequency t + phase).",
     [](text::KeyList& to) {
       to.need("amplitude", Type::number, "In the unit of the output.")
           .need("frequency", Type::positive, "Its frequency.", {.unit = "Hz"})
           .may("phase", Type::number, "Its phase.", {.unit = "rad", .otherwise = "0.0"})
           .may("mean", Type::number, "In the unit of the output.", {.otherwise = "0.0"});
     }},
    {"piecewise_linear", piecewise_linear, "Values at points of time.", [](text::KeyList& to) {
       to.need("times", Type::numbers, "Times.", {.unit = "s"})
           .need("values", Type::numbers, "One for each time.")
           .may("low", Type::number, "The least value that is allowed.", {.otherwise = "-inf"})
           .may("high", Type::number, "The largest value that is allowed.", {.otherwise = "inf"});
       text::keys_of_joining(to, "hold");
     }}};

}  // namespace tandem::engine
