// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "scaled.hpp"

namespace tandem::mbs {
namespace {

using Eigen::VectorXd;

VectorXd all_of(const std::vector<double>& scales, int size) {
  if (scales.empty()) return VectorXd::Ones(size);
  return Eigen::Map<const VectorXd>(scales.data(), size);
}

}  // namespace

/// What is divided once: the masses, and the sizes of constraints.
Scaled::Scaled(Model& of)
    : model_(of),
      structure_(of.structure()),
      s_(all_of(structure_.coordinate_scales, structure_.coordinates)),
      p_(all_of(structure_.constraint_scales, structure_.constraints)),
      q_(structure_.coordinates),
      v_(structure_.coordinates) {
  structure_.coordinate_scales.clear();
  structure_.constraint_scales.clear();
  divide(structure_.mass.pattern, structure_.mass.values.data());
  for (std::size_t c = 0; c < structure_.constraint_sizes.size(); ++c)
    structure_.constraint_sizes[c] *= p_[static_cast<Eigen::Index>(c)];
}

const double* Scaled::restored(const double* x, VectorXd& into) const {
  into = Eigen::Map<const VectorXd>(x, s_.size()).cwiseQuotient(s_);
  return into.data();
}

void Scaled::divide(const Pattern& pattern, double* values) const {
  for (int column = 0; column < pattern.columns(); ++column)
    for (int k = pattern.starts()[column]; k < pattern.starts()[column + 1]; ++k)
      values[k] /= s_[pattern.indices()[k]] * s_[column];
}

void Scaled::multiply_constraints(double* phi) const {
  Eigen::Map<VectorXd>(phi, p_.size()).array() *= p_.array();
}

void Scaled::constraints(const double* x, double* phi, double* jacobian) const {
  model_.constraints(restored(x, q_), phi, jacobian);
  multiply_constraints(phi);
  const Pattern& pattern = structure_.jacobian;
  for (int column = 0; column < pattern.columns(); ++column)
    for (int k = pattern.starts()[column]; k < pattern.starts()[column + 1]; ++k)
      jacobian[k] *= p_[column] / s_[pattern.indices()[k]];
}

void Scaled::constraint_rates(const double* x, double* phi_t) const {
  model_.constraint_rates(restored(x, q_), phi_t);
  multiply_constraints(phi_t);
}

void Scaled::constraint_accelerations(const double* x, const double* v, double* gamma) const {
  model_.constraint_accelerations(restored(x, q_), restored(v, v_), gamma);
  multiply_constraints(gamma);
}

Off Scaled::off(int constraint, const double* x, double phi) const {
  const Off off = model_.off(constraint, restored(x, q_), phi / p_[constraint]);
  return {off.now, off.per_phi / p_[constraint]};
}

void Scaled::forces(const double* x, const double* v, double* force) const {
  model_.forces(restored(x, q_), restored(v, v_), force);
  Eigen::Map<VectorXd>(force, structure_.variables).array() /= s_.head(structure_.variables).array();
}

void Scaled::force_derivatives(const double* x, const double* v, double* k, double* c) const {
  model_.force_derivatives(restored(x, q_), restored(v, v_), k, c);
  divide(structure_.stiffness, k);
  divide(structure_.stiffness, c);
}

double Scaled::energy(const double* x, const double* v) const {
  return model_.energy(restored(x, q_), restored(v, v_));
}

void Scaled::scale(State& s) const {
  for (VectorXd* x : {&s.q, &s.v, &s.a})
    if (x->size() > 0) x->array() *= s_.array();
  if (s.lambda.size() > 0) s.lambda.array() /= p_.array();
}

void Scaled::restore(State& s) const {
  for (VectorXd* x : {&s.q, &s.v, &s.a})
    if (x->size() > 0) x->array() /= s_.array();
  if (s.lambda.size() > 0) s.lambda.array() *= p_.array();
}

void ScaledStepper::start(State& s) {
  model_.scale(s);
  stepper_->start(s);
  model_.restore(s);
}

int ScaledStepper::step(State& s, double h, double t_end) {
  model_.scale(s);
  const int iterations = stepper_->step(s, h, t_end);
  model_.restore(s);
  return iterations;
}

void ScaledStepper::refresh(State& s) {
  model_.scale(s);
  stepper_->refresh(s);
  model_.restore(s);
}

}  // namespace tandem::mbs
