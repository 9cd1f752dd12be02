// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "kinds.hpp"
#include "made.hpp"

namespace tandem::engine {
namespace {

using Code = Operation::Code;

void constant(Lowering& to, Arguments& a) { to.define("", to.constant(a.number("value"))); }

/// before, until `time`, where there is an event; then after.
void step(Lowering& to, Arguments& a) {
  const double t = a.number("time");
  const int before = to.constant(a.number("before", 0.0)), level = to.constant(a.number("after"));
  const int wanted = to.operation(Code::compare, to.time(), to.constant(t));
  const int after = to.mode(wanted, {to.linear(-t, 1.0, to.time())});
  to.define("", to.operation(Code::select, level, before, {}, after));
}

/// start + slope (t - time) from `time` on.
void ramp(Lowering& to, Arguments& a) {
  const int since = to.linear(-a.number("time", 0.0), 1.0, to.time());
  const std::vector<double> limits = {0.0, std::numeric_limits<double>::infinity()};
  const int mode = to.mode(to.operation(Code::beyond, since, 0, limits), {since});
  to.define("", to.linear(a.number("start", 0.0), a.number("slope"),
                          to.operation(Code::clamp, since, 0, limits, mode)));
}

/// mean + amplitude sin(2 pi frequency t + phase).
void sine(Lowering& to, Arguments& a) {
  const double turn = 2.0 * std::numbers::pi * a.positive("frequency");
  const int angle = to.linear(a.number("phase", 0.0), turn, to.time());
  const int wave = to.operation(Code::function, angle, 0);
  to.define("", to.linear(a.number("mean", 0.0), a.number("amplitude"), wave));
}

/// Values at their key must be within `low` and `high`, if these are given.
void check_values(Arguments& a, const std::vector<double>& values) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const double low = a.number("low", -none), high = a.number("high", none);
  for (const double value : values)
    if (!(value >= low && value <= high))
      a.refuse("values", fmt::format("an array with {}", value), fmt::format("{} to {}", low, high));
}

/// Straight lines through points of time; before the first and after the last its value.
void piecewise_linear(Lowering& to, Arguments& a) {
  Curve curve = made(a, [&] {
    return Curve(a.owner(), a.numbers("times"), a.numbers("values"), Curve::Between::linear,
                 Curve::Beyond::hold);
  });
  check_values(a, a.numbers("values"));
  for (const double t : curve.x()) to.kink(t);
  to.define("", to.curve(std::move(curve), to.time()));
}

}  // namespace

const std::vector<BlockKind> source_blocks = {{"constant", constant},
                                              {"step", step},
                                              {"ramp", ramp},
                                              {"sine", sine},
                                              {"piecewise_linear", piecewise_linear}};

}  // namespace tandem::engine
