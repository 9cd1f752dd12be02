// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>

#include "tandem/transports/open.hpp"

namespace tandem {

/// Adds "fmu:FILE": an FMU of FMI 2.0 or 3.0 (docs/fmi.md), with the parameters
///  - `type`: cs (Co-Simulation, where it is offered) or me (Model Exchange);
///  - `step`: own step [s]; by default the FMU's;
///  - `set.NAME`, `unit.NAME`: a value for a variable before the start, a unit for a port;
///  - `outputs.NAME` = true: the variable is an output;
///  - `tolerance`: told to the FMU; `log`: whether all that it writes is told;
///  - of Co-Simulation `inputs`: what an input is over a step (mean, left, right, middle, derivatives with
///    `order`, intermediate); `lands`: steps may be cut; `state` = trust: the FMU's state is the whole of it.
/// `tell` takes what the FMU says, and that a value was rounded.
void add_fmi(Builtins& builtins, const std::function<void(const std::string&)>& tell = {});

}  // namespace tandem
