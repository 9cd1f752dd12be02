// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/mechanism/limits.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::kart {

/// "kart.point" and "kart.plane", levels i and ii of the kart in closed formulas. Input: torque on the driven
/// shaft [N m]. Parameters: `step` [s]; `integrator` ("newmark" or "rk4") and `beta` of the former; of the
/// plane `tyre` (tyres.hpp) and `formulas` ("printed" or "complete", plane.hpp). `tell` takes what the limits
/// of the plane tell.
void add_builtins(Builtins& builtins, const mbs::TellOfLimit& tell = {});

}  // namespace tandem::kart
