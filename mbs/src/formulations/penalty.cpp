// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/formulations/penalty.hpp"

namespace tandem::mbs {

Penalty::Penalty(Model& model, const PenaltySettings& s)
    : Stabilized("penalty formulation", model, {s.penalty, s.xi, s.omega, s.solver}) {}

void Penalty::solve(State& s) {
  terms_.weights = alpha_ * terms_.error;
  terms_.correct(s, terms_.weights, 1.0);
  s.a.head(size()) += terms_.correction;
}

void Penalty::multipliers(State& s) {
  terms_.follow_correction();
  s.lambda = alpha_ * terms_.error;
}

}  // namespace tandem::mbs
