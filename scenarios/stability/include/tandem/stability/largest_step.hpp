// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/stability/super_step.hpp"

namespace tandem::stability {

/// How long the steps of a scenario may be. All go in proportion: own steps and the communication step.
struct LargestStep {
  bool linear;  ///< SuperStep::linear
  double
      factor;  ///< of the scenario's steps; 0: not even at smallest_factor(), infinite: even at largest_factor
  std::string whose;  ///< who goes first, whose own step counts; "communication step" of `parallel`
  double step;        ///< that step in the scenario [s]
};
constexpr double largest_factor = 1e3;
/// Differences of what is not linear say nothing of far shorter steps.
constexpr double smallest_factor(bool linear) { return linear ? 1e-3 : 1.0 / 32.0; }

/// The largest steps up to which nothing grows that does not in the system undivided (is_stable): by a scan from the
/// smallest factor by factors of 1.1, then bisection to 1e-6. Throws Error as super_step() does, and for a subsystem of
/// which no parameter is known to make its own step.
LargestStep largest_step(const scenario::Scenario& scenario, const Builtins& builtins);

}  // namespace tandem::stability
