// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/engine/description.hpp"

namespace tandem::engine_linkage {

/// The engine's diagram with the linkage of so many loops in it, on the parallelogram's branch: w = -phi' the
/// speed of the first bar, phi its angle from +x, pi/2 at the start,
///   [(4 L + 1)/3 + 14] w' = T - 3.18 w + 9.81 (3 L + 1)/2 cos phi,
/// T the engine's torque on the bar, 14 kg m^2 its rotor there. engine: with the input `speed`, which becomes
/// w.
engine::Description monolithic(engine::Description engine, int loops);

}  // namespace tandem::engine_linkage
