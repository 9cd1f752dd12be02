// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/transports/open.hpp"

namespace tandem::scenario {

/// Adds "builtin:impulse_surrogate", which coordination.coupling puts between two sides. Its parameters are those of
/// ImpulseCoupling: own_step, slow_step and fast_period [s]; of each link K from 1 velocity.K, free_acceleration.K,
/// force_unit.K and displacement_unit.K; accelerance.K, stiffness.K and damping.K, matrices by rows; trapezoidal; degree.
void add_impulse(Builtins& builtins);

}  // namespace tandem::scenario
