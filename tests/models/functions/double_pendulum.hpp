// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/model.hpp"

namespace tandem::functions {

/// The double pendulum of scenarios/functions/double_pendulum.m with its terms in C++: the same variables,
/// constraints and dense matrices.
class DoublePendulum final : public mbs::Model {
 public:
  DoublePendulum();
  /// Where it starts: level and at rest.
  static mbs::State level();

  const mbs::Structure& structure() const override { return structure_; }
  void at_time(double) override {}
  void constraints(const double* q, double* phi, double* jacobian) const override;
  void constraint_rates(const double* q, double* phi_t) const override;
  void constraint_accelerations(const double* q, const double* v, double* gamma) const override;
  void forces(const double* q, const double* v, double* force) const override;
  void force_derivatives(const double*, const double*, double*, double*) const override {}
  double energy(const double* q, const double* v) const override;

 private:
  mbs::Structure structure_;
};

}  // namespace tandem::functions
