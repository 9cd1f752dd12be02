// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "instance.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

#include "number_text.hpp"

namespace tandem::checks {
namespace {

constexpr double untouched = 6.02214076e23;
constexpr int most_calls = 1000;  // a call makes a step or says why not; there are some 20

std::string whole(std::int64_t number) { return std::to_string(number); }

}  // namespace

void require_same(const Rows& found, const Rows& expected, const std::string& what) {
  require(found.size() == expected.size(), what + ": " + whole(static_cast<std::int64_t>(found.size())) +
                                               " samples; allowed is " +
                                               whole(static_cast<std::int64_t>(expected.size())));
  for (std::size_t row = 0; row < found.size(); ++row)
    for (std::size_t k = 0; k < found[row].size(); ++k) {
      const double a = found[row][k], b = expected[row][k];
      require(std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b),
              what + ": sample " + std::to_string(row) + " at t = " + number_text(expected[row][0]) +
                  " s has " + number_text(a) + " in its column " + std::to_string(k) + "; allowed is " +
                  number_text(b) + ", to the last bit");
    }
}

Instance::Instance(const Subject& of)
    : subsystem(of.open()), t_start_(of.settings.t_start), tolerance_(of.settings.t_start) {
  require(subsystem != nullptr, "there is no subsystem; allowed is one");
  if (can().sampled) throw LeftOut("it is sampled and takes no own steps");
  make_signals(of.settings.inputs, of.settings.constant);
  initialize(u0_);
}

void Instance::make_signals(const std::vector<double>& inputs, const std::vector<bool>& constant) {
  const auto& info = subsystem->info();
  const auto count = static_cast<std::size_t>(info.input_size());
  require(inputs.empty() || inputs.size() == count,
          whole(static_cast<std::int64_t>(inputs.size())) +
              " values of inputs are given; allowed is one for each of " +
              whole(static_cast<std::int64_t>(count)));
  for (std::size_t k = 0; k < count; ++k) {
    const Scalar scalar = scalar_at(info.inputs, static_cast<int>(k));
    const double start = scalar.port->start_of(scalar.element);
    const double usual = std::isfinite(start) ? start : 1.0 + 0.25 * static_cast<double>(k);
    const double a = inputs.empty() || std::isnan(inputs[k]) ? usual : inputs[k], t = t_start_;
    const double b = k < constant.size() && constant[k] ? 0.0 : 1.0;
    pieces_.push_back({{t + 0.13, t, {a, 0.5 * b, -1.0 * b, 0.0}},
                       {t + 0.31, t, {a, 0.4 * b, -0.5 * b, 0.3 * b}},
                       {t + 0.5, t, {a, 0.3 * b, 0.2 * b, -0.1 * b}}});
  }
  for (const auto& pieces : pieces_)
    signals_.emplace_back(pieces.data(), 3, 3), u0_.push_back(pieces[0].c[0]);
}

Clock Instance::initialize(const std::vector<double>& u0) {
  rows.clear();
  return clock = call(1, [&](Samples& y) { return subsystem->initialize(t_start_, t_start_ + 1e6, u0, y); });
}

Clock Instance::initialize_at(double t) {
  std::vector<double> u0;
  for (const Signal& input : signals_) u0.push_back(input.value(t));
  t_start_ = t;
  return initialize(u0);
}

void Instance::react(const tandem_reactive_input* by, std::int32_t states) {
  signals_[0] = signals_[0].with(by), states_ = states;
}

void Instance::raise_first_input(double by) {
  for (Segment& one : pieces_[0]) one.c[0] += by;
}

void Instance::let_last_input_jump(double t) {
  const double a = pieces_.back()[0].c[0];
  Segment after{t_start_ + 1e6, t, {a + 0.125}};
  mark_jump(after, true);
  pieces_.back() = {{t, t_start_, {a}}, after, after};
}

Clock Instance::call_once(double t_limit, bool land, std::int64_t room) {
  return clock = call(room, [&](Samples& y) { return subsystem->advance(t_limit, land, signals_, y); });
}

void Instance::advance(double t_limit, bool land, std::int64_t room) {
  if (clock.stop == Stop::finished)
    throw LeftOut("it says that it is finished at t = " + number_text(clock.time) + " s");
  for (int calls = 0; call_once(t_limit, land, room).stop == Stop::event && can().events; ++calls)
    require(calls < most_calls, "it stops at an event at t = " + number_text(clock.time) +
                                    " s, as in each of " + std::to_string(most_calls) + " calls before");
}

void Instance::go_to(double t_limit, bool land, std::int64_t room) {
  for (int calls = 0;
       !tolerance_.before(t_limit, clock.next_time) || (land && tolerance_.before(clock.time, t_limit));
       ++calls) {
    require(calls < most_calls, "it stands at t = " + number_text(clock.time) + " s after " +
                                    std::to_string(most_calls) + " calls of advance up to " +
                                    number_text(t_limit) + " s; allowed are as many as there are steps");
    advance(t_limit, land, room);
  }
}

/// Rows of earlier calls may stand before.
template <class Call>
Clock Instance::call(std::int64_t room, const Call& make) {
  const std::int64_t stride = subsystem->info().row_size() + states_, first = rows.empty() ? 0 : 1;
  std::vector<double> memory(static_cast<std::size_t>((room + first + 1) * stride), untouched);
  Samples y(memory.data(), stride, room + first, first);
  const Clock result = make(y);
  require(y.size() >= first && y.size() <= room + first, "a call left " + whole(y.size()) +
                                                             " samples; allowed is " + whole(first) + " to " +
                                                             whole(room + first));
  take(memory, y, first);
  const double newest = rows.empty() ? result.time : rows.back()[0];
  require(result.time == newest, "its clock stands at t = " + number_text(result.time) + " s; allowed is " +
                                     number_text(newest) + ", the time of its newest sample");
  require(result.stop == Stop::finished || result.next_time > result.time,
          "its clock says that the next step ends at t = " + number_text(result.next_time) +
              " s; allowed is a time after " + number_text(result.time));
  return result;
}

void Instance::take(const std::vector<double>& memory, const Samples& y, std::int64_t first) {
  const std::int64_t stride = y.stride();
  for (std::int64_t k = 0; k < static_cast<std::int64_t>(memory.size()); ++k)
    require(
        (k >= first * stride && k < y.size() * stride) || memory[static_cast<std::size_t>(k)] == untouched,
        "it wrote outside the samples that it appended");
  for (std::int64_t row = first; row < y.size(); ++row)
    rows.emplace_back(memory.begin() + row * stride, memory.begin() + (row + 1) * stride);
}

Rows in_one_call(const Subject& of, double t, bool land) {
  Instance other(of);
  other.advance(t, land);
  return other.rows;
}

}  // namespace tandem::checks
