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
  if (!subsystem_) subsystem_ = opened();
  Samples y(rows_.data(), info_.row_size(), most_rows);
  at_start_ = inputs_.values();
  clock_ = subsystem_->initialize(start_, stop_, at_start_, y);
  take(y);
  own_step_ = info_.abilities.sampled ? info_.sampling.period : clock_.next_time - clock_.time;
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

void Unit::follow_inputs(const Variable& v) {
  start();
  if (!begun_ || !inputs_set_ || info_.abilities.sampled || !follows_[static_cast<std::size_t>(v.index)]) return;
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

bool Unit::step(double t, double length) {
  const TimeTolerance tolerance(start_);
  if (!(length > 0.0) || !std::isfinite(length))
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("the step from t = {} s is {} s long; allowed is a finite number above 0", t, length));
  if (tolerance.before(t, time_) || tolerance.before(time_, t) || std::isnan(t))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("a step is wanted from t = {} s, but it stands at {} s", t, time_));
  begin();
  const double end = t + length;
  const auto u = inputs_.over(t, end);
  const bool goes_on = info_.abilities.sampled ? run_instants(end, u) : run(end, u);
  inputs_.step_done(t);
  inputs_set_ = false;
  time_ = goes_on ? end : clock_.time;
  return goes_on;
}

/// Importers add up their communication points. One that is off a node of the own steps by less than this is that
/// node, so that no step is cut for a rounding.
double Unit::slack() { return 1e-9 * own_step(); }

bool Unit::run(double end, std::span<const Signal> u) {
  advance(end + slack(), false, u);
  if (clock_.stop != Stop::finished && clock_.time < end - slack()) advance(end, true, u);
  return clock_.stop != Stop::finished;
}

void Unit::advance(double limit, bool land, std::span<const Signal> u) {
  do {
    Samples y(rows_.data(), info_.row_size(), most_rows);
    clock_ = subsystem_->advance(limit, land, u, y);
    take(y);
  } while (clock_.stop == Stop::samples_full || clock_.stop == Stop::event);
}

/// Those after the begin, up to and with the end: what it gives there is told there, as in a run of tandem.
bool Unit::run_instants(double end, std::span<const Signal> u) {
  while (clock_.stop != Stop::finished && clock_.next_time <= end + slack())
    act(clock_.next_time, SamplePart::both, u);
  return clock_.stop != Stop::finished;
}

void Unit::act(double t, SamplePart part, std::span<const Signal> u) {
  const Clock clock = subsystem_->sample(t, part, at(u, t), row_);
  if (part != SamplePart::outputs) clock_ = clock;
}

void Unit::reset() {
  changed_.clear();
  subsystem_.reset();
  inputs_ = Inputs(start_values());
  fresh_ = begun_ = inputs_set_ = false;
  set_span(0.0);
}

}  // namespace tandem::exported
