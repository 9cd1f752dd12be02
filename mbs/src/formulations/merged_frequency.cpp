// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "merged_frequency.hpp"

#include <cmath>

#include "tandem/mbs/integrators/frequency.hpp"

namespace tandem::mbs {

using Eigen::VectorXd;

MergedFrequency::MergedFrequency(Terms& terms)
    : terms_(terms),
      stiffness_rows_(terms.structure.stiffness),
      argument_(terms.structure.variables),
      product_(argument_),
      force_(argument_) {}

/// factor Phi_q^T lambda, where moved_ stands.
void MergedFrequency::add_constraint_forces(double factor, VectorXd& to) {
  terms_.constraints(moved_);
  terms_.jacobian_rows.multiply(terms_.matrices.jacobian.data(), moved_.lambda.data(), force_.data());
  to += factor * force_;
}

/// z <- (K + d(Phi_q^T lambda)/dq) z, the second part by central differences. K as factorize() left it.
void MergedFrequency::multiply_stiffness(const State& s, VectorXd& z) {
  const double reach = 1e-6 * (terms_.structure.unit() + s.q.norm());
  stiffness_rows_.multiply(terms_.matrices.stiffness.data(), z.data(), product_.data());
  moved_.q.head(z.size()) = s.q.head(z.size()) + reach * z;
  add_constraint_forces(0.5 / reach, product_);
  moved_.q.head(z.size()) = s.q.head(z.size()) - reach * z;
  add_constraint_forces(-0.5 / reach, product_);
  z = product_;
}

double MergedFrequency::at(const State& s, double penalty) {
  moved_ = s;
  terms_.model.at_time(s.time);
  terms_.constraints(s);
  terms_.factorize(s, {0.0, 0.0, penalty});
  return std::sqrt(spectral_radius(argument_, [&](VectorXd& z) {
    multiply_stiffness(s, z);
    terms_.solve(z);
  }));
}

}  // namespace tandem::mbs
