// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace tandem::engine_linkage {

/// The text of scenarios/engine_linkage/linkage.toml for any number of loops: the linkage upright, its first
/// moving point at 30 m/s, 14 kg m^2 of the engine's rotor in the first crank, a damping of 3.18 N m s/rad on
/// it, input `torque`, outputs `speed`, `angle`, `energy`.
std::string linkage_text(int loops);

}  // namespace tandem::engine_linkage
