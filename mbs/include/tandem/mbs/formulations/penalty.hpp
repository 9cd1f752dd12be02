// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/mbs/formulations/stabilized.hpp"

namespace tandem::mbs {

struct PenaltySettings {
  double penalty = 0.0;  ///< alpha; 0: 1e7 times the largest mass term
  double xi = 1.0;       ///< Baumgarte's damping ratio
  double omega = 10.0;   ///< Baumgarte's frequency [rad/s]
  std::string solver = "auto";

  bool operator==(const PenaltySettings&) const = default;
};

/// Penalty formulation (E. Bayo, J. Garcia de Jalon, M. A. Serna, Comput. Methods Appl. Mech. Eng. 71 (1988)
/// 183), rhs as in Stabilized:
///   (M + alpha Phi_q^T Phi_q) q'' = Q - alpha Phi_q^T rhs,  lambda = alpha (Phi_q q'' + rhs).
/// It is solved for the difference to the accelerations at hand,
///   q'' <- q'' + T^-1 [Q - M q'' - alpha Phi_q^T (Phi_q q'' + rhs)],
/// which is the same but for rounding: alpha rhs is not rounded into free directions. Constraints are
/// satisfied to rest at Phi = lambda/(alpha omega^2); with omega = 0 they drift, as far as Stabilized lets
/// them.
class Penalty final : public Stabilized {
 public:
  Penalty(Model& model, const PenaltySettings& settings);

 private:
  void solve(State& s) override;
  void multipliers(State& s) override;
};

}  // namespace tandem::mbs
