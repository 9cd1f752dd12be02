// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/stability/super_step.hpp"

namespace tandem::stability {

/// How long the steps of a scenario may be. All go in proportion: own steps and the communication step.
struct LargestStep {
  /// Of the scenario's steps; 0: not even at `smallest`, infinite: even at largest_factor.
  double factor;
  double smallest;    ///< factor that was tried
  std::string whose;  ///< who goes first, whose own step counts; "communication step" of `parallel`
  double step;        ///< that step in the scenario [s]
  /// Why no larger step could be looked at: the limit may lie beyond. Empty: it is the limit.
  std::string beyond = {};
};
constexpr double largest_factor = 1e3;
/// The largest steps up to which nothing grows that does not in the system undivided (is_stable): by a scan from the
/// smallest factor by factors of 1.1, then bisection to 1e-6. The smallest is 1e-3. Of what is not linear or samples it is 1
/// if the scenario's own steps are stable, else 1/16: differences say nothing of far shorter steps, and periods stay and
/// make the map dear. Throws Error as super_step() does, and for a subsystem of which no parameter
/// is known to make its own step.
LargestStep largest_step(const scenario::Scenario& scenario, const Builtins& builtins);

}  // namespace tandem::stability
