// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/engine/compiled_block.hpp"

namespace tandem::engine_models {

/// Kinds of block in C++ for what the diagrams of scenarios/engine have of listed blocks; equations and
/// sources stand in scenarios/engine/README.md. What has to change at an event comes in as an input, held by
/// a switch beside the block.
/// - `manifold_core`: manifold.toml but for the cylinders. Inputs throttle [deg], out [g/s], unchoked (1 or
///   0: q above 1/2); outputs P [bar], q, of its state P alone.
/// - `cylinders_core`: what they take. Inputs N [rad/s], P [bar]; output out [g/s].
/// - `converter_core`: converter.toml. Inputs N, turbine [rad/s], fill, driving (slip above 0), multiplying
///   (its torque ratio above 1); outputs impeller, output [N m], slip [rad/s], multiplied.
std::vector<engine::CompiledBlock> compiled_kinds();

}  // namespace tandem::engine_models
