// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "tandem/mbs/mechanism/limits.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::engine_linkage {

/// scenarios/engine_linkage/linkage.toml with any number of loops: the linkage upright, its first moving
/// point at 30 m/s, 14 kg m^2 of the engine's rotor in the first crank, a damping of 3.18 N m s/rad on it,
/// input `torque`, outputs `speed`, `angle`, `energy`. Parameters: `loops` (1, 2, ... 1000000; 1), and those
/// of a mechanism's file. Throws Error for other loops.
std::unique_ptr<Subsystem> make_linkage(Parameters& parameters, const mbs::TellOfLimit& tell = {});

/// "engine_linkage.linkage".
void add_builtins(Builtins& builtins, const mbs::TellOfLimit& tell = {});

}  // namespace tandem::engine_linkage
