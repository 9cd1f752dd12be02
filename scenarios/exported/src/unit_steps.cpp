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

double Unit::own_step() {
  if (info_.abilities.sampled) return info_.sampling.period;
  start();
  return clock_.next_time - clock_.time;
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
  time_ = goes_on ? end : clock_.time;
  return goes_on;
}

bool Unit::run(double end, std::span<const Signal> u) {
  do {
    Samples y(rows_.data(), info_.row_size(), most_rows);
    clock_ = subsystem_->advance(end, true, u, y);
    take(y);
  } while (clock_.stop == Stop::samples_full || clock_.stop == Stop::event);
  return clock_.stop != Stop::finished;
}

/// Those after the begin, up to and with the end: what it gives there is told there, as in a run of tandem.
bool Unit::run_instants(double end, std::span<const Signal> u) {
  const TimeTolerance tolerance(start_);
  while (clock_.stop != Stop::finished && !tolerance.before(end, clock_.next_time))
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
  fresh_ = begun_ = false;
  set_span(0.0);
}

}  // namespace tandem::exported
