// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/exported/unit.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::exported {
namespace {

std::vector<double> at(std::span<const Signal> u, double t) {
  std::vector<double> values;
  for (const Signal& signal : u) values.push_back(signal.value(t));
  return values;
}

}  // namespace

/// With all as it is, unless it is so already. What a sampled one gives at its start is told, and nothing done
/// yet.
void Unit::start() {
  if (fresh_) return;
  if (!subsystem_) reopen();
  Samples y(rows_.data(), info_.row_size(), most_rows);
  at_start_ = inputs_.values();
  clock_ = subsystem_->initialize(start_, stop_, at_start_, y);
  take(y);
  own_step_ = info_.abilities.sampled ? subsystem_->info().sampling.period : clock_.next_time - clock_.time;
  if (info_.abilities.sampled && clock_.next_time <= start_)
    act(start_, SamplePart::outputs, inputs_.over(start_, start_));
  fresh_ = true;
}

void Unit::begin() {
  start();
  if (!begun_ && info_.abilities.sampled && clock_.next_time <= start_)
    act(start_, SamplePart::both, inputs_.over(start_, start_));
  begun_ = true;
}

void Unit::follow_inputs() {
  start();
  if (!begun_ || !inputs_set_ || info_.abilities.sampled || info_.feedthrough.empty()) return;
  advance(clock_.time, false, inputs_.jumped(clock_.time));
  inputs_set_ = false;
}

double Unit::own_step() {
  start();
  return own_step_;
}

void Unit::take(const Samples& y) {
  if (y.size() == 0) return;
  const auto values = y.values(y.size() - 1);
  row_.assign(values.begin(), values.end());
}

void Unit::step(double t, double length) {
  check_step(t, length);
  begin();
  const double begin = place_, end = place_ + length;
  const auto u = inputs_.over(begin, end);
  info_.abilities.sampled ? run_instants(end, u) : run(end, u);
  place_ = std::abs(clock_.time - end) <= slack() ? clock_.time : end;
  inputs_.step_done(begin);
  inputs_set_ = false;
  time_ = t + length;
}

void Unit::check_step(double t, double length) const {
  const TimeTolerance tolerance(start_);
  const auto refuse = [](const std::string& what) { throw Error(ErrorCode::invalid_argument, what); };
  if (!(length > 0.0) || !std::isfinite(length))
    refuse(fmt::format("the step from t = {} s is {} s long; allowed is a finite number above 0", t, length));
  if (tolerance.before(t, time_) || tolerance.before(time_, t) || std::isnan(t))
    refuse(fmt::format("a step is wanted from t = {} s, but it stands at {} s", t, time_));
  if (constexpr double rounding = 1e-6; t + length > stop_ + rounding * length)
    refuse(fmt::format("the step from t = {} s is {} s long, past the stop at {} s", t, length, stop_));
}

/// A communication point that is off a node by less than this is that node.
double Unit::slack() const { return 1e-9 * own_step_; }

void Unit::run(double end, std::span<const Signal> u) {
  advance(end + slack(), false, u);
  if (clock_.time < end - slack()) advance(end, true, u);
}

void Unit::advance(double limit, bool land, std::span<const Signal> u) {
  do {
    Samples y(rows_.data(), info_.row_size(), most_rows);
    clock_ = subsystem_->advance(limit, land, u, y);
    take(y);
  } while (clock_.stop == Stop::samples_full || clock_.stop == Stop::event);
}

/// Those after the begin, up to and with the end: what it gives there is told there, as in a run of tandem.
void Unit::run_instants(double end, std::span<const Signal> u) {
  while (clock_.next_time <= end + slack()) act(clock_.next_time, SamplePart::both, u);
}

void Unit::act(double t, SamplePart part, std::span<const Signal> u) {
  const Clock clock = subsystem_->sample(t, part, at(u, t), row_);
  if (part != SamplePart::outputs) clock_ = clock;
}

void Unit::reset() {
  changed_.clear();
  parameters_ = file_parameters();
  subsystem_.reset();
  inputs_ = Inputs(start_values());
  fresh_ = begun_ = inputs_set_ = false;
  set_span(0.0);
}

}  // namespace tandem::exported
