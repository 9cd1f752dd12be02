// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/formulations/penalty.hpp"

namespace tandem::mbs {

Penalty::Penalty(Model& model, const PenaltySettings& s)
    : Stabilized("penalty formulation", model, {s.penalty, s.xi, s.omega, s.solver}) {}

void Penalty::solve(State& s) {
  terms_.violation(s.a, rhs_);
  terms_.weights = alpha_ * terms_.error;
  terms_.correct(s, terms_.weights, 1.0);
  s.a.head(size()) += terms_.correction;
}

void Penalty::multipliers(State& s) {
  terms_.violation(s.a, rhs_);
  s.lambda = alpha_ * terms_.error;
}

/// From accelerations that may be far off: once more takes off what rounding left.
void Penalty::solve_at_start(State& s) {
  solve(s);
  solve(s);
}

}  // namespace tandem::mbs
