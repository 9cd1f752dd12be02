// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/model.hpp"

namespace tandem::four_bar {

/// The linkage of text(loops) with its terms written out for it alone, with the same numbering: what the
/// general assembler is measured against. Variables are x and y of B0, B1, ...; constraints are the lengths
/// of the cranks, then those of the couplers:
///   Phi_i = |B_i - A_i|^2 - 1,  Phi_(L+1+i) = |B_(i+1) - B_i|^2 - 1.
class HandWritten final : public mbs::Model {
 public:
  /// Precondition: loops >= 1.
  explicit HandWritten(int loops);

  const mbs::Structure& structure() const override { return structure_; }
  void at_time(double) override {}
  void constraints(const double* q, double* phi, double* jacobian) const override;
  void constraint_rates(const double* q, double* phi_t) const override;
  void constraint_accelerations(const double* q, const double* v, double* gamma) const override;
  void forces(const double* q, const double* v, double* force) const override;
  void force_derivatives(const double*, const double*, double*, double*) const override {}
  double energy(const double* q, const double* v) const override;

  /// Cranks upright, moving points at 1 m/s in x.
  mbs::State first_state() const;

 private:
  int loops_;
  mbs::Structure structure_;
  std::vector<double> weight_;
};

}  // namespace tandem::four_bar
