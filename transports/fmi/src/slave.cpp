// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "slave.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "over_step.hpp"
#include "tandem/error.hpp"

namespace tandem::fmi {

Slave::Slave(const std::shared_ptr<Instance>& instance) : running_(instance), values_(info().inputs.size()) {
  const auto& variables = instance->fmu().description.variables;
  for (int k = 0; k < std::ssize(variables); ++k)
    if (const Variable& v = variables[static_cast<std::size_t>(k)];
        v.causality == Causality::independent && v.type == Type::real)
      own_time_ = k;
  const Settings& settings = instance->fmu().settings;
  if (settings.held != Held::derivatives) return;
  for (int order = 1; order <= settings.order; ++order)
    for (const Seat& seat : instance->fmu().ports.continuous) {
      references_.push_back(variables[static_cast<std::size_t>(seat.variable)].reference);
      orders_.push_back(order);
    }
  derivatives_.resize(references_.size());
}

void Slave::start(const TimeSpan& span, std::span<const double> u0) {
  finished_ = false;
  const bool ends = std::isfinite(span.stop);
  instance().within(
      [&] { running_.initialize(span.start, ends ? std::optional(span.stop) : std::nullopt, u0); });
}

double Slave::over(const OwnStep& s, const Signal& u) const {
  switch (running_.fmu().settings.held) {
    case Held::mean:
      return mean_over(u, s);
    case Held::right:
      return u.value(s.end);
    case Held::middle:
      return u.value(s.begin + 0.5 * s.length);
    default:
      return u.value(s.begin);
  }
}

void Slave::set_inputs(const OwnStep& s, std::span<const Signal> u) {
  const Ports& ports = running_.fmu().ports;
  for (const Seat& seat : ports.continuous)
    values_[static_cast<std::size_t>(seat.place)] = over(s, u[static_cast<std::size_t>(seat.place)]);
  for (const Seat& seat : ports.discrete)
    values_[static_cast<std::size_t>(seat.place)] = u[static_cast<std::size_t>(seat.place)].value(s.begin);
  running_.set_continuous(values_.data(), s.begin);
  running_.set_discrete(values_.data(), s.begin);
  if (!references_.empty()) set_derivatives(s.begin, u);
}

void Slave::set_derivatives(double t, std::span<const Signal> u) {
  std::size_t k = 0;
  for (int order = 1; order <= running_.fmu().settings.order; ++order)
    for (const Seat& seat : running_.fmu().ports.continuous) {
      const Signal& signal = u[static_cast<std::size_t>(seat.place)];
      derivatives_[k++] = order == 1 ? signal.derivative(t) : signal.second_derivative(t);
    }
  instance().call(&Functions::SetRealInputDerivatives, "fmi2SetRealInputDerivatives", references_.data(),
                  references_.size(), orders_.data(), derivatives_.data());
}

double Slave::step(const OwnStep& s, std::span<const Signal> u) {
  running_.resume();
  running_.know_inputs();
  set_inputs(s, u);
  const fmi2Boolean never_back = keeps_state() ? fmi2False : fmi2True;
  const fmi2Status status = instance().ask(&Functions::DoStep, s.begin, s.length, never_back);
  if (status == fmi2Discard) return discarded(s);
  instance().check("fmi2DoStep", status);
  if (own_time_ >= 0) check_own_time(s);
  if (!running_.has_followed()) return s.end;
  for (const Seat& seat : running_.fmu().ports.followed)
    values_[static_cast<std::size_t>(seat.place)] = u[static_cast<std::size_t>(seat.place)].value(s.end);
  running_.set_followed(values_.data(), s.end);
  return s.end;
}

/// Of a step that it has not taken to its end: it is one that ends there, or an error.
double Slave::discarded(const OwnStep& s) {
  fmi2Boolean terminated = fmi2False;
  double reached = s.begin;
  const bool told = instance().ask(&Functions::GetBooleanStatus, fmi2Terminated, &terminated) <= fmi2Warning;
  if (!told || terminated == fmi2False) instance().check("fmi2DoStep", fmi2Discard);
  instance().call(&Functions::GetRealStatus, "fmi2GetRealStatus", fmi2LastSuccessfulTime, &reached);
  finished_ = true;
  return std::clamp(reached, s.begin, s.end);
}

/// One that says that it has taken a step, and has not: the difference is a good part of the step, where sums
/// of rounded steps are far below a hundredth of it.
void Slave::check_own_time(const OwnStep& s) {
  const Variable& v = running_.fmu().description.variables[static_cast<std::size_t>(own_time_)];
  double now = 0.0;
  instance().call(&Functions::GetReal, "fmi2GetReal", &v.reference, std::size_t{1}, &now);
  if (std::abs(now - s.end) <= 0.01 * s.length) return;
  throw Error(
      ErrorCode::numerical,
      fmt::format("the FMU says that it has taken the step from {} to {} s, but its own time, '{}', is {} s; "
                  "allowed is a step that it can take",
                  s.begin, s.end, v.name, now));
}

void Slave::write(ByteWriter& to) const {
  running_.write(to);
  to.put(std::uint8_t{finished_});
}

void Slave::read(ByteReader& from) {
  running_.read(from);
  finished_ = from.take<std::uint8_t>() != 0;
}

}  // namespace tandem::fmi
