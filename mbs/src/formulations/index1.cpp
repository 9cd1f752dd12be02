// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/formulations/index1.hpp"

#include "checks.hpp"
#include "settings.hpp"

namespace tandem::mbs {

Index1::Index1(Model& model, const Index1Settings& s)
    : Stabilized("index-1 formulation", model, {s.penalty, s.xi, s.omega, s.solver}), settings_(s) {
  Setting{"index-1 formulation", "tolerance", s.tolerance}.positive();
  Setting{"index-1 formulation", "multiplier_iterations", static_cast<double>(s.multiplier_iterations)}
      .count();
}

void Index1::solve(State& s) {
  if (!settings_.carry_multipliers) s.lambda.setZero();
  if (terms_.settle(s, alpha_, settings_.tolerance, settings_.multiplier_iterations) == 0)
    refuse_unsettled(settings_.multiplier_iterations, s.time);
}

}  // namespace tandem::mbs
