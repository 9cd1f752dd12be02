// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tandem/scenario/scenario.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::scenario {

/// Multiplies all own steps and the communication step of a scenario by `factor`. Sampled subsystems keep
/// their instants. Which parameter makes an own step is tried: `step`, one whose value is the own step, or the
/// inverse of one that is named steps_per_... The scenario may leave out one of that name, which the source itself has.
/// Throws Error for a subsystem of which none does.
void scale_steps(Scenario& scenario, const Builtins& builtins, double factor);

/// Likewise own steps alone, each by a factor: of it and the shortest of those that are not sampled [s].
void scale_each_step(Scenario& scenario, const Builtins& builtins,
                     const std::function<double(double own, double shortest)>& factor);

/// Likewise those that a parameter is known to make; the others stay.
void scale_known_steps(Scenario& scenario, const Builtins& builtins, double factor);

/// A parameter that has another value in a scenario with other own steps.
struct ChangedStep {
  std::string subsystem, parameter;
  double value;
};
/// Those of `scaled` beside the scenario that it was, in the order of its subsystems.
std::vector<ChangedStep> changed_steps(const Scenario& scenario, const Scenario& scaled);

/// Whether all can be.
bool can_scale_steps(const Scenario& scenario, const Builtins& builtins);

/// Whether the scenario gives its communication step, or a parameter that makes an own step. Throws Error as scale_steps.
bool states_steps(const Scenario& scenario, const Builtins& builtins);

}  // namespace tandem::scenario
