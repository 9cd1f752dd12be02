// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/residuals.hpp"

#include "tandem/mbs/sparse/products.hpp"

namespace tandem::mbs {

Residuals residuals(Model& model, const State& s) {
  const Structure& structure = model.structure();
  if (structure.constraints == 0) return {};
  Eigen::VectorXd phi(structure.constraints), extra(phi), product(phi), jacobian(structure.jacobian_values());
  const auto largest = [&](const Eigen::VectorXd& x) {
    multiply_transposed(structure.jacobian, jacobian.data(), x.data(), product.data());
    return (product + extra).lpNorm<Eigen::Infinity>();
  };
  model.at_time(s.time);
  model.constraints(s.q.data(), phi.data(), jacobian.data());
  Residuals r{phi.lpNorm<Eigen::Infinity>()};
  model.constraint_rates(s.q.data(), extra.data());
  r.velocity = largest(s.v);
  model.constraint_accelerations(s.q.data(), s.v.data(), extra.data());
  r.acceleration = largest(s.a);
  return r;
}

}  // namespace tandem::mbs
