// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/mbs/formulations/stabilized.hpp"

namespace tandem::mbs {

struct Index1Settings {
  double penalty = 0.0;            ///< alpha; 0: 1e7 times the largest mass term
  double xi = 1.0;                 ///< Baumgarte's damping ratio
  double omega = 10.0;             ///< Baumgarte's frequency [rad/s]
  double tolerance = 1e-12;        ///< see Terms::settle
  int multiplier_iterations = 10;  ///< in an evaluation; then it has failed
  bool carry_multipliers = false;  ///< they begin with those of the evaluation before, not with zero
  std::string solver = "auto";

  bool operator==(const Index1Settings&) const = default;
};

/// Augmented Lagrangian of index 1 (E. Bayo, J. Garcia de Jalon, M. A. Serna, Comput. Methods Appl. Mech.
/// Eng. 71 (1988) 183): M q'' + Phi_q^T lambda = Q, Phi_q q'' + rhs = 0, rhs as in Stabilized, by iteration
/// of
///   (M + alpha Phi_q^T Phi_q) q'' = Q - Phi_q^T (lambda + alpha rhs),
///   then lambda <- lambda + alpha (Phi_q q'' + rhs)
/// with one factor (Terms::settle, which writes it for differences). An error falls to the part
/// 1/(1 + alpha sigma^2) in an iteration, sigma a singular value of Phi_q in the metric of the mass; with
/// redundant constraints the multipliers are those of the least norm.
class Index1 final : public Stabilized {
 public:
  Index1(Model& model, const Index1Settings& settings);

 private:
  void solve(State& s) override;

  Index1Settings settings_;
};

}  // namespace tandem::mbs
