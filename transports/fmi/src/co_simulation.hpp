// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "instance.hpp"
#include "tandem/subsystem.hpp"

namespace tandem::fmi {

/// An FMU of Co-Simulation: one fmi2DoStep for each own step.
std::unique_ptr<Subsystem> make_co_simulation(std::shared_ptr<Instance> instance);

}  // namespace tandem::fmi
