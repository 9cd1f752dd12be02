// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "measurements.hpp"

#include <algorithm>

namespace tandem::mbs {

Measurements::Measurements(const Mechanism& mechanism, const std::vector<Output>& outputs)
    : mechanism_(mechanism), q_(mechanism.structure().coordinates), v_(q_.size()) {
  for (const Output& output : outputs) {
    ones_.emplace_back();
    if (output.kind == Output::Kind::quantity) add(output, ones_.back());
  }
  rates_.resize(values_.size());
  before_.resize(values_.size());
}

void Measurements::add(const Output& output, One& to) {
  const auto& element = *mechanism_.description().elements[static_cast<std::size_t>(output.element)].force;
  const auto quantities = element.quantities();
  const auto number = static_cast<std::size_t>(output.quantity);
  const std::size_t place = place_of(output.element);
  to = {measured_[place].first + number, quantities[number].unit, quantities[number].follows_inputs};
  if (!to.follows_inputs) measured_[place].has_rates = true;
}

/// Among the measured elements, of which it becomes one.
std::size_t Measurements::place_of(int element) {
  const auto found = std::find(elements_.begin(), elements_.end(), element);
  if (found != elements_.end()) return static_cast<std::size_t>(found - elements_.begin());
  const auto& force = *mechanism_.description().elements[static_cast<std::size_t>(element)].force;
  elements_.push_back(element);
  measured_.push_back({GatheredElement(force, mechanism_.numbering()), values_.size(), false});
  values_.resize(values_.size() + force.quantities().size());
  return measured_.size() - 1;
}

void Measurements::measure(Measured& of, const double* q, const double* v, std::vector<double>& to) {
  of.element.element().measure(of.element.gather(q, v, mechanism_.inputs()), to.data() + of.first);
}

void Measurements::measure(const State& s) {
  for (Measured& m : measured_) measure(m, s.q.data(), s.v.data(), values_);
}

void Measurements::measure_ahead(const State& s, double by, std::vector<double>& to) {
  q_ = s.q + by * s.v + 0.5 * by * by * s.a;
  v_ = s.v + by * s.a;
  for (Measured& m : measured_)
    if (m.has_rates) measure(m, q_.data(), v_.data(), to);
}

void Measurements::measure_rates(const State& s) {
  constexpr double by = 1e-5;  // [s]
  measure_ahead(s, by, rates_);
  measure_ahead(s, -by, before_);
  for (std::size_t k = 0; k < rates_.size(); ++k) rates_[k] = (rates_[k] - before_[k]) / (2.0 * by);
}

}  // namespace tandem::mbs
