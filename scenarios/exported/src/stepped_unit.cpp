// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/exported/stepped_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::exported {
namespace {

std::vector<double> at(std::span<const Signal> u, double t) {
  std::vector<double> values;
  for (const Signal& signal : u) values.push_back(signal.value(t));
  return values;
}

}  // namespace

SteppedUnit::SteppedUnit(const std::filesystem::path& resources, const Tell& tell) : Unit(resources, tell) {
  rows_.resize(static_cast<std::size_t>(info_.row_size() * most_rows));
}

/// What a sampled one gives at its start is told, and nothing done yet.
void SteppedUnit::start_source() {
  Samples y(rows_.data(), info_.row_size(), most_rows);
  clock_ = subsystem_->initialize(start_, stop_, at_start_, y);
  place_ = start_;
  take(y);
  own_step_ = info_.abilities.sampled ? subsystem_->info().sampling.period : clock_.next_time - clock_.time;
  if (info_.abilities.sampled && clock_.next_time <= start_)
    act(start_, SamplePart::outputs, inputs_.over(start_, start_));
}

void SteppedUnit::begin_source() {
  if (info_.abilities.sampled && clock_.next_time <= start_)
    act(start_, SamplePart::both, inputs_.over(start_, start_));
}

void SteppedUnit::follow_inputs() {
  if (!begun_ || !inputs_set_ || info_.abilities.sampled || info_.feedthrough.empty()) return;
  advance(clock_.time, false, inputs_.jumped(clock_.time));
  inputs_set_ = false;
}

double SteppedUnit::own_step() {
  start();
  return own_step_;
}

void SteppedUnit::take(const Samples& y) {
  if (y.size() == 0) return;
  const auto values = y.values(y.size() - 1);
  row_.assign(values.begin(), values.end());
}

void SteppedUnit::step(double t, double length) {
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

void SteppedUnit::check_step(double t, double length) const {
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
double SteppedUnit::slack() const { return 1e-9 * own_step_; }

void SteppedUnit::run(double end, std::span<const Signal> u) {
  advance(end + slack(), false, u);
  if (clock_.time < end - slack()) advance(end, true, u);
}

void SteppedUnit::advance(double limit, bool land, std::span<const Signal> u) {
  do {
    Samples y(rows_.data(), info_.row_size(), most_rows);
    clock_ = subsystem_->advance(limit, land, u, y);
    take(y);
  } while (clock_.stop == Stop::samples_full || clock_.stop == Stop::event);
}

/// Those after the begin, up to and with the end: what it gives there is told there, as in a run of tandem.
void SteppedUnit::run_instants(double end, std::span<const Signal> u) {
  while (clock_.next_time <= end + slack()) act(clock_.next_time, SamplePart::both, u);
}

void SteppedUnit::act(double t, SamplePart part, std::span<const Signal> u) {
  const Clock clock = subsystem_->sample(t, part, at(u, t), row_);
  if (part != SamplePart::outputs) clock_ = clock;
}

void SteppedUnit::set_derivative(std::size_t reference, int order, double value) {
  const Variable& v = of_kind(reference, Variable::Kind::input, "input");
  if (!std::isfinite(value))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("derivative {} of '{}' at t = {} s is {}; allowed is a finite number", order,
                            v.name, time_, value));
  inputs_.set_derivative(v.index, order, value);
}

double SteppedUnit::output(const Variable& v) {
  return output(v.index, v.kind == Variable::Kind::derivative ? v.order : 0);
}

double SteppedUnit::output(int index, int order) {
  follow_inputs();
  return row_[static_cast<std::size_t>(order * info_.output_size() + index)];
}

double SteppedUnit::derivative(std::size_t reference, int order) {
  const Variable& v = variable(reference);
  const bool known = v.kind == Variable::Kind::output || v.kind == Variable::Kind::derivative;
  if (!known || order < 1 || order > scalar_at(info_.outputs, v.index).port->derivatives)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("variable '{}' has no time derivative of order {}", v.name, order));
  start();
  return output(v.index, order);
}

void SteppedUnit::write_started(ByteWriter& to) {
  to.put_list(row_);
  for (const double t : {place_, clock_.time, clock_.next_time}) to.put(t);
  to.put(static_cast<std::int32_t>(clock_.stop));
  const StateId id = subsystem_->save_state();
  to.put_bytes(subsystem_->serialize_state(id));
  subsystem_->release_state(id);
}

void SteppedUnit::read_started(ByteReader& from, double, const Inputs&) {
  std::vector<double> row(static_cast<std::size_t>(info_.row_size() - Samples::header));
  from.take_list(row);
  const auto place = from.take<double>();
  Clock clock{};
  clock.time = from.take<double>(), clock.next_time = from.take<double>();
  clock.stop = static_cast<Stop>(from.take<std::int32_t>());
  const StateId id = subsystem_->deserialize_state(from.take_bytes(from.left()));
  subsystem_->restore_state(id);
  subsystem_->release_state(id);
  row_ = std::move(row), clock_ = clock, place_ = place;
}

}  // namespace tandem::exported
