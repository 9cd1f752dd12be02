// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem::fmi {

Equations::Equations(const std::shared_ptr<Instance>& instance)
    : running_(instance),
      x_(static_cast<std::size_t>(instance->fmu().description.state_size())),
      indicators_(static_cast<std::size_t>(instance->fmu().description.event_indicators)),
      inputs_(static_cast<std::size_t>(running_.info().input_size())),
      above_(indicators_.size()) {}

void Equations::start(double t, std::span<const double> u0) {
  finished_ = false;
  running_.initialize(t, std::nullopt, u0);
  put_start(running_.info().inputs, u0, inputs_);
  settle(t);
}

static std::vector<StateName> states_of(const Description& d) {
  std::vector<StateName> all;
  for (const Unknown& rate : d.derivatives) {
    const Variable& state = d.at(d.at(rate.variable).derivative_of);
    const Port port{state.name, state.unit, state.size};
    for (int k = 0; k < state.size; ++k) all.push_back({Scalar{&port, k}.name(), state.unit});
  }
  return all;
}

std::vector<std::string> Equations::state_names() const {
  std::vector<std::string> all;
  for (const StateName& state : states_of(running_.fmu().description)) all.push_back(state.name);
  return all;
}

std::vector<double> Equations::nominals() const {
  const Description& d = running_.fmu().description;
  std::vector<double> all;
  for (const Unknown& rate : d.derivatives) {
    const Variable& state = d.at(d.at(rate.variable).derivative_of);
    all.insert(all.end(), static_cast<std::size_t>(state.size), state.nominal);
  }
  return all;
}

std::optional<std::vector<StateName>> Equations::names() const {
  const Description& d = running_.fmu().description;
  const auto is_discrete = [](const Variable& v) { return v.variability == Variability::discrete; };
  if (d.event_indicators > 0 || std::any_of(d.variables.begin(), d.variables.end(), is_discrete)) return {};
  return states_of(d);
}

void Equations::put(std::span<const double> x) {
  running_.resume();
  std::copy(x.begin(), x.end(), x_.begin());
  if (!x_.empty()) instance().set_states(x_);
}

void Equations::resume(std::span<const Signal> u) {
  u_ = given_ = u;
  course_end_ = -std::numeric_limits<double>::infinity();
  running_.resume();
  running_.know_inputs();
}

/// A break belongs to the piece before it, so pieces that end at t go.
bool Equations::begin_course(double t) {
  course_.assign(given_.begin(), given_.end()), u_ = course_;
  const TimeTolerance tolerance(t);
  course_end_ = std::numeric_limits<double>::infinity();
  for (Signal& signal : course_) {
    auto pieces = signal.segments();
    while (pieces.size() > 1 && !tolerance.before(t, pieces.front().end)) pieces = pieces.subspan(1);
    if (pieces.size() > 1) course_end_ = std::min(course_end_, pieces.front().end);
    signal = Signal(pieces.data(), 1, signal.degree());
  }
  inputs_before_ = inputs_;
  if (!take(running_.fmu().ports.continuous, u_, t, inputs_)) return false;
  evaluate(t);
  return !std::equal(inputs_.begin(), inputs_.end(), inputs_before_.begin(), [](double a, double b) {
    return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
  });
}

/// The sign of one is that it is above zero.
void Equations::watched_signs(double* signs) const {
  std::transform(indicators_.begin(), indicators_.end(), signs, [](double z) {
    return std::abs(z) >= smallest_sign ? z : z > 0.0 ? smallest_sign : -smallest_sign;
  });
}

bool Equations::discrete_inputs_changed(double t) {
  return take(running_.fmu().ports.discrete, u_, t, inputs_);
}

void Equations::go_to(double t) {
  instance().set_time(t);
  if (!x_.empty()) instance().set_states(x_);
  take(running_.fmu().ports.continuous, u_, t, inputs_);
  running_.set_continuous(inputs_.data(), t);
}

void Equations::read_rates(double* dx) {
  if (!x_.empty()) instance().get_rates(dx, x_.size());
}

void Equations::evaluate(double t) {
  go_to(t);
  read_indicators();
}

void Equations::evaluate_again(double t) {
  if (!take(running_.fmu().ports.continuous, u_, t, inputs_)) return;
  running_.set_continuous(inputs_.data(), t);
  read_indicators();
}

int Equations::changed() const {
  for (std::size_t k = 0; k < indicators_.size(); ++k)
    if ((indicators_[k] > 0.0) != (above_[k] > 0.0)) return static_cast<int>(k);
  return -1;
}

bool Equations::end_step() {
  if (running_.fmu().description.model_exchange->needs_no_completed_steps) return false;
  const Completed completed = instance().complete_step(!running_.keeps_state());
  finished_ = finished_ || completed.ended;
  return completed.event;
}

/// The FMU may not look at its event before its time, which t is but for rounding.
void Equations::happen(double t) {
  if (next_event_ > t && std::isfinite(next_event_) && !TimeTolerance(t).before(t, next_event_))
    instance().set_time(next_event_);
  instance().enter_events();
  running_.set_discrete(inputs_.data(), t);
  settle(t);
}

/// From event mode, or the end of initialization, to continuous time.
void Equations::settle(double t) {
  const Updated updated = running_.settle(t);
  finished_ = finished_ || updated.ended;
  if (finished_) return;
  next_event_ = updated.next_event;
  instance().enter_continuous_time();
  read_states();
  read_indicators();
  std::transform(indicators_.begin(), indicators_.end(), above_.begin(),
                 [](double z) { return z > 0.0 ? 1.0 : 0.0; });
}

void Equations::read_states() {
  if (!x_.empty()) instance().get_states(x_);
}

void Equations::read_indicators() {
  if (!indicators_.empty()) instance().get_indicators(indicators_);
}

void Equations::write(ByteWriter& to) const {
  running_.write(to);
  for (const auto* list : {&x_, &indicators_, &inputs_, &above_}) to.put_list(*list);
  to.put(next_event_);
  to.put(std::uint8_t{finished_});
}

void Equations::read(ByteReader& from) {
  running_.read(from);
  for (auto* list : {&x_, &indicators_, &inputs_, &above_}) from.take_list(*list);
  next_event_ = from.take<double>();
  finished_ = from.take<std::uint8_t>() != 0;
}

}  // namespace tandem::fmi
