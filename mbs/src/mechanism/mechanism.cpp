// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "constraint_set.hpp"
#include "force_set.hpp"

namespace tandem::mbs {

State Mechanism::described_state() const {
  State s;
  const Description& in = description_;
  s.q.setZero(structure_.coordinates);
  s.v.setZero(structure_.coordinates);
  s.a.setZero(structure_.coordinates);
  s.lambda.setZero(structure_.constraints);
  for (std::size_t i = 0; i < in.entities.size(); ++i) {
    const Entity& e = in.entities[i];
    s.q.segment(numbering_.entity[i], in.dimension) = e.at.head(in.dimension);
    if (!e.fixed) s.v.segment(numbering_.entity[i], in.dimension) = e.velocity.head(in.dimension);
  }
  for (std::size_t i = 0; i < in.relatives.size(); ++i)
    s.q[numbering_.relative[i]] = drawn(in, in.relatives[i]);
  return s;
}

void Mechanism::at_time(double t) {
  for (std::size_t i = 0; i < inputs_.size(); ++i)
    if (const auto& function = description_.inputs[i].function) inputs_[i] = function(t);
  if (source_) source_->at(t, inputs_);
}

void Mechanism::reset_inputs() {
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const auto follows = [i](const Drive& d) { return d.input == static_cast<int>(i); };
    if (std::any_of(description_.drives.begin(), description_.drives.end(), follows)) continue;
    const Input& input = description_.inputs[i];
    if (input.unit == "m" || input.unit == "rad") continue;
    inputs_[i] = {std::isnan(input.value) ? 0.0 : input.value};
  }
}

void Mechanism::constraints(const double* q, double* phi, double* jacobian) const {
  for (const auto& set : sets_) set->values(q, phi, jacobian);
}

void Mechanism::constraint_rates(const double*, double* phi_t) const {
  std::fill_n(phi_t, structure_.constraints, 0.0);
  for (const auto& set : sets_) set->rates(phi_t);
}

void Mechanism::constraint_accelerations(const double* q, const double* v, double* gamma) const {
  for (const auto& set : sets_) set->accelerations(q, v, gamma);
}

Off Mechanism::off(int constraint, const double* q, double phi) const {
  auto set = sets_.begin();
  for (; constraint >= (*set)->size(); ++set) constraint -= (*set)->size();
  return (*set)->off(constraint, q, phi);
}

void Mechanism::forces(const double* q, const double* v, double* force) const {
  if (force_sets_.empty()) {
    std::copy_n(weight_.data(), structure_.variables, force);
    return;
  }
  all_forces(q, v, force_.data());
  std::copy_n(force_.data(), structure_.variables, force);
}

void Mechanism::all_forces(const double* q, const double* v, double* force) const {
  std::copy_n(weight_.data(), structure_.coordinates, force);
  for (const auto& set : force_sets_) set->add(q, v, force);
}

void Mechanism::force_derivatives(const double* q, const double* v, double* k, double* c) const {
  std::fill_n(k, structure_.stiffness_values(), 0.0);
  std::fill_n(c, structure_.stiffness_values(), 0.0);
  for (const auto& set : force_sets_) set->add_derivatives(q, v, k, c);
}

double Mechanism::kinetic(const double* v) const {
  double sum = 0.0;
  const Pattern& p = structure_.mass.pattern;
  for (int column = 0; column < p.columns(); ++column)
    for (int k = p.starts()[column]; k < p.starts()[column + 1]; ++k)
      sum += structure_.mass.values[k] * v[p.indices()[k]] * v[column];
  for (const int i : structure_.states) sum -= v[i] * v[i];
  return 0.5 * sum;
}

double Mechanism::potential(const double* q) const {
  double sum = 0.0;
  for (int i = 0; i < structure_.coordinates; ++i) sum -= weight_[i] * q[i];
  for (const auto& set : force_sets_) sum += set->potential(q);
  return sum;
}

}  // namespace tandem::mbs
