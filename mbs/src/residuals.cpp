// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/residuals.hpp"

#include "tandem/mbs/sparse/products.hpp"

namespace tandem::mbs {

ConstraintResiduals::ConstraintResiduals(const Structure& s)
    : phi_(s.constraints), extra_(phi_), jacobian_(s.jacobian_values()) {}

Residuals ConstraintResiduals::operator()(const Model& model, const State& s) {
  const Structure& structure = model.structure();
  if (structure.constraints == 0) return {};
  model.constraints(s.q.data(), phi_.data(), jacobian_.data());
  Residuals r{phi_.lpNorm<Eigen::Infinity>()};
  model.constraint_rates(s.q.data(), extra_.data());
  r.velocity = largest(structure, s.v);
  model.constraint_accelerations(s.q.data(), s.v.data(), extra_.data());
  r.acceleration = largest(structure, s.a);
  return r;
}

double ConstraintResiduals::largest(const Structure& structure, const Eigen::VectorXd& x) {
  multiply_transposed(structure.jacobian, jacobian_.data(), x.data(), phi_.data());
  return (phi_ + extra_).lpNorm<Eigen::Infinity>();
}

Residuals residuals(Model& model, const State& s) {
  model.at_time(s.time);
  return ConstraintResiduals(model.structure())(model, s);
}

}  // namespace tandem::mbs
