// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "measurements.hpp"

#include <algorithm>
#include <utility>

namespace tandem::mbs {

Measurements::Measurements(const Mechanism& mechanism, const std::vector<Output>& outputs)
    : mechanism_(mechanism) {
  for (const Output& output : outputs) {
    ones_.emplace_back();
    if (output.kind == Output::Kind::quantity) add(output, ones_.back());
  }
  for (auto* list : {&rates_, &before_, &after_}) list->resize(values_.size());
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
  const std::size_t first = values_.size(), last = first + force.quantities().size();
  auto sizes = sizes_of(mechanism_.description(), force, mechanism_.structure().unit());
  measured_.push_back({GatheredElement(force, mechanism_.numbering(), std::move(sizes)), first, last, false});
  values_.resize(last);
  return measured_.size() - 1;
}

void Measurements::measure(Measured& of, const ElementState& at, std::vector<double>& to) {
  of.element.element().measure(at, to.data() + of.first);
}

void Measurements::measure(const State& s) {
  for (Measured& m : measured_)
    measure(m, m.element.gather(s.q.data(), s.v.data(), mechanism_.inputs()), values_);
}

/// Of dy/dt = y_q v + y_v a what is along q or along v, by a central difference over a part of the time in
/// which that changes by what counts as much: errors by curvature of 1e-10 and by rounding of 1e-11.
void Measurements::measure_rates(const State& s) {
  constexpr double part = 1e-5;
  std::fill(rates_.begin(), rates_.end(), 0.0);
  for (Measured& m : measured_) {
    if (!m.has_rates) continue;
    m.element.gather(s.q.data(), s.v.data(), mechanism_.inputs());
    add_difference(m, s, part * m.element.time_of_sizes(s), 1.0, 0.0);
    add_difference(m, s, part * m.element.time_of_rates(s), 0.0, 1.0);
  }
}

void Measurements::add_difference(Measured& m, const State& s, double by, double along_q, double along_v) {
  measure(m, m.element.ahead(s, by * along_q, by * along_v), after_);
  measure(m, m.element.ahead(s, -by * along_q, -by * along_v), before_);
  for (std::size_t k = m.first; k < m.last; ++k) rates_[k] += (after_[k] - before_[k]) / (2.0 * by);
}

}  // namespace tandem::mbs
