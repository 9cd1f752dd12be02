// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "merged_frequency.hpp"

#include <cmath>

#include "tandem/mbs/integrators/frequency.hpp"

namespace tandem::mbs {
namespace {

using Eigen::VectorXd;

/// Phi_q^T x, Phi_q where s stands.
VectorXd constraint_forces(Terms& terms, const State& s, const VectorXd& x) {
  VectorXd y(terms.structure.variables);
  terms.constraints(s);
  terms.jacobian_rows.multiply(terms.matrices.jacobian.data(), x.data(), y.data());
  return y;
}

/// z <- (K + d(Phi_q^T lambda)/dq) z, the second part by central differences. K as factorize() left it.
void multiply_stiffness(Terms& terms, const State& s, VectorXd& z) {
  const double reach = 1e-6 * (terms.structure.unit() + s.q.norm());
  State above = s, below = s;
  above.q.head(z.size()) += reach * z;
  below.q.head(z.size()) -= reach * z;
  const VectorXd lambda = s.lambda / (2.0 * reach);
  VectorXd product(z.size());
  Rows(terms.structure.stiffness).multiply(terms.matrices.stiffness.data(), z.data(), product.data());
  z = product + constraint_forces(terms, above, lambda) - constraint_forces(terms, below, lambda);
}

}  // namespace

double merged_frequency(Terms& terms, const State& s, double penalty) {
  terms.model.at_time(s.time);
  terms.constraints(s);
  terms.factorize(s, {0.0, 0.0, penalty});
  return std::sqrt(spectral_radius(terms.structure.variables, [&](VectorXd& z) {
    multiply_stiffness(terms, s, z);
    terms.solve(z);
  }));
}

}  // namespace tandem::mbs
