// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "tandem/differential_system.hpp"
#include "tandem/transports/open.hpp"

namespace tandem {

/// Integrators for Model Exchange besides the classical Runge-Kutta method.
struct FmuIntegrators {
  Words words = {};  ///< that `make` asks for
  /// By the parameter `integrator` and the settings of the one that it names; null: it names the classical
  /// method.
  std::function<std::unique_ptr<AdaptiveIntegrator>(Parameters&)> make = {};
};

/// Adds "fmu:FILE": an FMU of FMI 2.0 or 3.0 (docs/fmi.md), with the parameters
///  - `type`: cs (Co-Simulation, where it is offered) or me (Model Exchange);
///  - `step`: own step [s]; by default the FMU's;
///  - `set.NAME`, `unit.NAME`: a value for a variable before the start, a unit for a port;
///  - `outputs.NAME` = true: the variable is an output;
///  - `tolerance`: told to the FMU; `log`: whether all that it writes is told;
///  - of Co-Simulation `inputs`: what an input is over a step (mean, left, right, middle, derivatives with
///    `order`, intermediate); `lands`: steps may be cut; `state` = trust: the FMU's state is the whole of it.
/// `tell` takes what the FMU says, and that a value was rounded. `integrators` brings words of its own.
void add_fmi(Builtins& builtins, const std::function<void(const std::string&)>& tell = {},
             const FmuIntegrators& integrators = {});

}  // namespace tandem
