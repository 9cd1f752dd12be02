// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "kinds.hpp"

namespace tandem::engine {
namespace {

using Code = Operation::Code;
using Direction = Crossing::Direction;

/// The limits of an integrator, and the held mode that says at which of them its state stands: -1, 0, 1.
struct Limits {
  double low, high;
  int mode;

  /// A value that is put, cut to the limits.
  int cut(Lowering& to, int value) const {
    return to.operation(Code::clamp, value, 0, {low, high},
                        to.operation(Code::beyond, value, 0, {low, high}));
  }
  /// The mode with a value that is put: at a limit unless the input points inwards.
  int mode_at(Lowering& to, int value, int input) const {
    constexpr double most = std::numeric_limits<double>::infinity();
    const int at =
        to.operation(Code::beyond, value, 0, {std::nextafter(low, most), std::nextafter(high, -most)});
    return to.operation(Code::leave, input, 0, {}, at);
  }
};

/// A factor of a state's derivative that is 0 while the state is held at a limit: it gets there where it
/// rises above `high` or falls below `low`, and leaves it where its input points inwards again.
int freedom(Lowering& to, int state, int input, const Limits& limits) {
  for (const bool above : {true, false}) {
    const double limit = above ? limits.high : limits.low;
    if (!std::isfinite(limit)) continue;
    const int event =
        to.crossing(to.linear(-limit, 1.0, state), above ? Direction::rising : Direction::falling);
    to.events[event].effect = Event::Effect::limit;
    to.update(event, state, to.constant(limit));
    to.update(event, limits.mode, to.constant(above ? 1.0 : -1.0));
  }
  const int outwards = to.operation(Code::product, input, limits.mode);
  to.update(to.crossing(outwards, Direction::falling), limits.mode, to.constant(0.0));
  return to.operation(Code::polynomial, limits.mode, 2, {1.0, 0.0, -1.0});
}

std::optional<Limits> limits_of(Lowering& to, Arguments& a) {
  const double low = a.number("low"), high = a.number("high");
  if (!(low < high)) a.refuse("low", fmt::format("{}", low), fmt::format("below high, {}", high));
  if (!std::isfinite(low) && !std::isfinite(high)) return std::nullopt;
  return Limits{low, high, to.held()};
}

/// What a state is put to: a number within the limits, or a signal, which is cut to them.
int put(Lowering& to, Arguments& a, const char* key, const std::optional<Limits>& limits) {
  const int value = a.wire(key);
  const Slot& slot = to.signals[value];
  if (limits && slot.kind == Slot::Kind::constant && (slot.start < limits->low || slot.start > limits->high))
    a.refuse(key, fmt::format("{}", slot.start), fmt::format("{} to {}", limits->low, limits->high));
  return value;
}

/// state' = input from `initial` on, within limits if there are; back to `reset_to` where `reset` rises above
/// 0.
void integrator(Lowering& to, Arguments& a) {
  const int state = to.state(-1), input = a.wire("input");
  const auto limits = limits_of(to, a);
  const int initial = put(to, a, "initial", limits);
  to.start(state, limits ? limits->cut(to, initial) : initial);
  if (limits) to.start(limits->mode, limits->mode_at(to, initial, input));
  to.signals[state].rate =
      limits ? to.operation(Code::product, input, freedom(to, state, input, *limits)) : input;
  if (a.has("reset")) {
    const int event = to.crossing(a.wire("reset"), Direction::rising), value = put(to, a, "reset_to", limits);
    to.update(event, state, limits ? limits->cut(to, value) : value);
    if (limits) to.update(event, limits->mode, limits->mode_at(to, value, input));
  }
  to.define("", state);
}

/// time y' = gain input - y.
void lag(Lowering& to, Arguments& a) {
  const double rate = 1.0 / a.positive("time");
  const int state = to.state(-1);
  to.start(state, a.wire("initial"));
  to.signals[state].rate = to.sum({a.wire("input"), state}, {rate * a.number("gain"), -rate});
  to.define("", state);
}

/// state' = (input - state) / time within -falling and rising.
void rate_limiter(Lowering& to, Arguments& a) {
  const double pace = 1.0 / a.positive("time");
  const std::vector<double> limits = {-a.positive("falling"), a.positive("rising")};
  const int input = a.wire("input"), state = to.state(-1);
  to.start(state, a.has("initial") ? a.wire("initial") : input);
  const int free = to.sum({input, state}, {pace, -pace});
  const int wanted = to.operation(Code::beyond, free, 0, limits);
  const int mode = to.mode(wanted, {to.linear(-limits[0], 1.0, free), to.linear(-limits[1], 1.0, free)});
  to.signals[state].rate = to.operation(Code::clamp, free, 0, limits, mode);
  to.define("", state);
}

/// The sum of signals, each times the factor of a row from `first` on.
int row(Lowering& to, const std::vector<int>& signals, const std::vector<double>& matrix, std::size_t first) {
  return to.sum(signals, {matrix.begin() + static_cast<std::ptrdiff_t>(first),
                          matrix.begin() + static_cast<std::ptrdiff_t>(first + signals.size())});
}

std::vector<double> matrix(Arguments& a, const char* key, std::size_t rows, std::size_t columns) {
  auto values = a.numbers(key);
  if (values.size() != rows * columns)
    a.refuse(key, fmt::format("an array of {}", values.size()),
             fmt::format("{} rows of {} numbers, one row after the other", rows, columns));
  return values;
}

/// So many, which others may read: BLOCK.x1, BLOCK.x2, ..
std::vector<int> states(Lowering& to, std::size_t count) {
  std::vector<int> x;
  for (std::size_t k = 0; k < count; ++k) {
    x.push_back(to.state(-1));
    to.define(fmt::format("x{}", k + 1), x.back());
  }
  return x;
}

/// x' = a x + b u, y = c x + d u, matrices row by row. One output is named as the block, more BLOCK.1,
/// BLOCK.2, ..
void state_space(Lowering& to, Arguments& a) {
  const auto u = a.wires("inputs");
  const auto n = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(a.numbers("a").size()))));
  const auto own = matrix(a, "a", n, n), in = matrix(a, "b", n, u.size()), all = a.numbers("c");
  const std::size_t outputs = std::max<std::size_t>(1, all.size() / n);
  const auto out = matrix(a, "c", outputs, n);
  const auto through =
      a.has("d") ? matrix(a, "d", outputs, u.size()) : std::vector<double>(outputs * u.size(), 0.0);
  const std::vector<int> x = states(to, n);
  for (std::size_t k = 0; k < n; ++k)
    to.signals[x[k]].rate = to.sum({row(to, x, own, k * n), row(to, u, in, k * u.size())}, {1.0, 1.0});
  for (std::size_t k = 0; k < outputs; ++k) {
    const int y = row(to, x, out, k * n);
    const bool passes = std::any_of(through.begin() + static_cast<std::ptrdiff_t>(k * u.size()),
                                    through.begin() + static_cast<std::ptrdiff_t>((k + 1) * u.size()),
                                    [](double d) { return d != 0.0; });
    to.define(outputs == 1 ? "" : std::to_string(k + 1),
              passes ? to.sum({y, row(to, u, through, k * u.size())}, {1.0, 1.0}) : y);
  }
}

/// Coefficients of the highest power first, in controllable canonical form: x_n = s^(n-1) w, w = input /
/// denominator.
void transfer_function(Lowering& to, Arguments& a) {
  auto num = a.numbers("numerator"), den = a.numbers("denominator");
  if (den[0] == 0.0) a.refuse("denominator", "0 in its highest power", "another number there");
  if (num.size() > den.size() || den.size() < 2)
    a.refuse("denominator", fmt::format("of order {}", den.size() - 1),
             fmt::format("{} or more", std::max<std::size_t>(1, num.size() - 1)));
  const double scale = den[0];
  num.insert(num.begin(), den.size() - num.size(), 0.0);
  for (double& c : num) c /= scale;
  for (double& c : den) c /= scale;
  const int input = a.wire("input");
  const std::size_t n = den.size() - 1;
  const std::vector<int> x = states(to, n);
  std::vector<int> terms;
  for (std::size_t k = 0; k + 1 < n; ++k) to.signals[x[k]].rate = x[k + 1];
  std::vector<double> own = {1.0}, out;
  terms.push_back(input);
  for (std::size_t k = 0; k < n; ++k) {
    terms.push_back(x[k]);
    own.push_back(-den[n - k]);
    out.push_back(num[n - k] - num[0] * den[n - k]);
  }
  to.signals[x[n - 1]].rate = to.sum(terms, own);
  const int y = to.sum(x, out);
  to.define("", num[0] == 0.0 ? y : to.sum({y, input}, {1.0, num[0]}));
}

/// u = kp e + I + D within limits; I' = ki e + back (u - its value without limits), D = kd e' by a lag of
/// 1/filter.
void pid(Lowering& to, Arguments& a) {
  const int e = a.wire("input"), integral = to.state(-1), filtered = to.state(-1);
  const double kp = a.number("kp"), ki = a.number("ki"), kd = a.number("kd");
  const double filter = a.positive("filter"), back = a.number("back");
  const double low = a.number("low"), high = a.number("high");
  if (!(low < high)) a.refuse("low", fmt::format("{}", low), fmt::format("below high, {}", high));
  to.start(integral, a.wire("initial"));
  to.define("integral", integral);
  to.define("filtered", filtered);
  const int slope = to.sum({e, filtered}, {filter * kd, -filter});
  to.signals[filtered].rate = slope;
  const int free = to.sum({e, integral, slope}, {kp, 1.0, 1.0});
  int u = free;
  if (std::isfinite(low) || std::isfinite(high)) {
    const int wanted = to.operation(Code::beyond, free, 0, {low, high});
    std::vector<int> crossed;
    for (const double limit : {low, high})
      if (std::isfinite(limit)) crossed.push_back(to.linear(-limit, 1.0, free));
    u = to.operation(Code::clamp, free, 0, {low, high}, to.mode(wanted, crossed));
  }
  to.signals[integral].rate = to.sum({e, u, free}, {ki, back, -back});
  to.define("", u);
}

void keys_of_integrator(text::KeyList& to) {
  to.need("input", Type::signal, "Its derivative.")
      .may("initial", Type::signal, "What it is at the start.", {.otherwise = "0.0"})
      .may("low", Type::number, "The least that it can be, where it stays until its input points inwards.",
           {.otherwise = "-inf"})
      .may("high", Type::number, "The most.", {.otherwise = "inf"})
      .may("reset", Type::signal, "Where this rises above 0 it is put to `reset_to`.")
      .may("reset_to", Type::signal, "See `reset`.", {.otherwise = "0.0"});
}

void keys_of_pid(text::KeyList& to) {
  to.need("input", Type::signal, "The error e.")
      .need("kp", Type::number, "Of e.")
      .may("ki", Type::number, "Of the integral of e.", {.unit = "1/s", .otherwise = "0.0"})
      .may("kd", Type::number, "Of the derivative of e.", {.unit = "s", .otherwise = "0.0"})
      .may("filter", Type::positive, "Of the derivative, by a lag of 1/filter.",
           {.unit = "1/s", .otherwise = "100.0"})
      .may("low", Type::number, "The least output.", {.otherwise = "-inf"})
      .may("high", Type::number, "The largest output.", {.otherwise = "inf"})
      .may("back", Type::number, "How fast a limited output pulls the integral back.",
           {.unit = "1/s", .otherwise = "1.0"})
      .may("initial", Type::signal, "The integral at the start.", {.otherwise = "0.0"});
}

}  // namespace

const std::vector<BlockKind> dynamic_blocks = {
    {"integrator", integrator, "The integral of a signal, within limits if there are.", keys_of_integrator},
    {"lag", lag, "time y' = gain input - y.",
     [](text::KeyList& to) {
       to.need("input", Type::signal, "The signal.")
           .need("time", Type::positive, "Its time constant.", {.unit = "s"})
           .may("gain", Type::number, "Of the input.", {.otherwise = "1.0"})
           .may("initial", Type::signal, "What it is at the start.", {.otherwise = "0.0"});
     }},
    {"rate_limiter", rate_limiter, "y' = (input - y) / time, within -falling and rising.",
     [](text::KeyList& to) {
       to.need("input", Type::signal, "The signal.")
           .need("rising", Type::positive, "The most, by time.")
           .need("falling", Type::positive, "The same downwards.")
           .need("time", Type::positive, "Its time constant within these.", {.unit = "s"})
           .may("initial", Type::signal, "What it is at the start; without it the input.");
     }},
    {"state_space", state_space, "x' = a x + b u, y = c x + d u; outputs `BLOCK.1`, .. if more than one.",
     [](text::KeyList& to) {
       to.need("inputs", Type::signals, "u.")
           .need("a", Type::numbers, "A matrix, row by row.")
           .need("b", Type::numbers, "A matrix, row by row.")
           .need("c", Type::numbers, "A matrix, row by row.")
           .may("d", Type::numbers, "A matrix, row by row; without it 0.");
     }},
    {"transfer_function", transfer_function, "numerator(s) / denominator(s) of a signal, from rest.",
     [](text::KeyList& to) {
       to.need("input", Type::signal, "The signal.")
           .need("numerator", Type::numbers, "Coefficients, that of the highest power first.")
           .need("denominator", Type::numbers, "Coefficients, that of the highest power first.");
     }},
    {"pid", pid, "kp e + its integral + its filtered derivative, within limits.", keys_of_pid}};

}  // namespace tandem::engine
