// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem::fmi {

Equations::Equations(const std::shared_ptr<Instance>& instance)
    : running_(instance),
      x_(instance->fmu().description.derivatives.size()),
      indicators_(static_cast<std::size_t>(instance->fmu().description.event_indicators)),
      inputs_(running_.info().inputs.size()),
      above_(indicators_.size()) {}

void Equations::start(double t, std::span<const double> u0) {
  finished_ = false;
  running_.initialize(t, std::nullopt, u0);
  for (std::size_t k = 0; k < inputs_.size(); ++k)
    inputs_[k] = std::isnan(u0[k]) ? running_.info().inputs[k].start : u0[k];
  settle(t);
}

std::optional<std::vector<StateName>> Equations::names() const {
  const Description& d = running_.fmu().description;
  const auto is_discrete = [](const Variable& v) { return v.variability == Variability::discrete; };
  if (d.event_indicators > 0 || std::any_of(d.variables.begin(), d.variables.end(), is_discrete)) return {};
  std::vector<StateName> all;
  for (const Unknown& rate : d.derivatives) {
    const Variable& v = d.variables[static_cast<std::size_t>(rate.variable)];
    const Variable& state = d.variables[static_cast<std::size_t>(v.derivative_of)];
    all.push_back({state.name, state.unit});
  }
  return all;
}

void Equations::put(std::span<const double> x) {
  running_.resume();
  std::copy(x.begin(), x.end(), x_.begin());
  if (!x_.empty())
    instance().call(&Functions::SetContinuousStates, "fmi2SetContinuousStates", x_.data(), x_.size());
}

void Equations::resume(std::span<const Signal> u) {
  u_ = u;
  running_.resume();
  running_.know_inputs();
}

bool Equations::take_continuous(double t) {
  bool differ = false;
  for (const Seat& seat : running_.fmu().ports.continuous) {
    double& now = inputs_[static_cast<std::size_t>(seat.place)];
    const double value = u_[static_cast<std::size_t>(seat.place)].value(t);
    differ = differ || value != now;
    now = value;
  }
  return differ;
}

bool Equations::discrete_inputs_changed(double t) {
  bool differ = false;
  for (const Seat& seat : running_.fmu().ports.discrete) {
    double& now = inputs_[static_cast<std::size_t>(seat.place)];
    const double value = u_[static_cast<std::size_t>(seat.place)].value(t);
    differ = differ || value != now;
    now = value;
  }
  return differ;
}

void Equations::go_to(double t) {
  instance().call(&Functions::SetTime, "fmi2SetTime", t);
  if (!x_.empty())
    instance().call(&Functions::SetContinuousStates, "fmi2SetContinuousStates", x_.data(), x_.size());
  take_continuous(t);
  running_.set_continuous(inputs_.data(), t);
}

void Equations::read_rates(double* dx) {
  if (!x_.empty()) instance().call(&Functions::GetDerivatives, "fmi2GetDerivatives", dx, x_.size());
}

void Equations::evaluate(double t) {
  go_to(t);
  read_indicators();
}

void Equations::evaluate_again(double t) {
  if (!take_continuous(t)) return;
  running_.set_continuous(inputs_.data(), t);
  read_indicators();
}

int Equations::changed() const {
  for (std::size_t k = 0; k < indicators_.size(); ++k)
    if ((indicators_[k] > 0.0) != (above_[k] > 0.0)) return static_cast<int>(k);
  return -1;
}

bool Equations::end_step() {
  fmi2Boolean event = fmi2False, end = fmi2False;
  if (running_.fmu().description.model_exchange->needs_no_completed_steps) return false;
  const fmi2Boolean never_back = running_.keeps_state() ? fmi2False : fmi2True;
  instance().call(&Functions::CompletedIntegratorStep, "fmi2CompletedIntegratorStep", never_back, &event,
                  &end);
  finished_ = finished_ || end != fmi2False;
  return event != fmi2False;
}

void Equations::happen(double t) {
  instance().call(&Functions::EnterEventMode, "fmi2EnterEventMode");
  running_.set_discrete(inputs_.data(), t);
  settle(t);
}

/// From event mode, or the end of initialization, to continuous time.
void Equations::settle(double t) {
  constexpr int most_rounds = 100;
  fmi2EventInfo info{};
  info.newDiscreteStatesNeeded = fmi2True;
  for (int round = 0; info.newDiscreteStatesNeeded != fmi2False; ++round) {
    if (round == most_rounds)
      throw Error(ErrorCode::numerical, "the FMU's event at t = " + std::to_string(t) +
                                            " s does not settle in 100 rounds of fmi2NewDiscreteStates");
    instance().call(&Functions::NewDiscreteStates, "fmi2NewDiscreteStates", &info);
    if (info.terminateSimulation != fmi2False) finished_ = true;
    if (finished_) return;
  }
  const bool known = info.nextEventTimeDefined != fmi2False;
  next_event_ = known ? info.nextEventTime : std::numeric_limits<double>::infinity();
  instance().call(&Functions::EnterContinuousTimeMode, "fmi2EnterContinuousTimeMode");
  read_states();
  read_indicators();
  std::transform(indicators_.begin(), indicators_.end(), above_.begin(),
                 [](double z) { return z > 0.0 ? 1.0 : 0.0; });
}

void Equations::read_states() {
  if (!x_.empty())
    instance().call(&Functions::GetContinuousStates, "fmi2GetContinuousStates", x_.data(), x_.size());
}

void Equations::read_indicators() {
  if (!indicators_.empty())
    instance().call(&Functions::GetEventIndicators, "fmi2GetEventIndicators", indicators_.data(),
                    indicators_.size());
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
