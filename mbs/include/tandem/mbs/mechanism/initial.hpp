// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>
#include <vector>

#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::mbs {

/// Coordinates, by their place in q, whose values at the start are known.
struct Known {
  std::vector<std::pair<int, double>> positions, velocities;
};

/// Positions and velocities that satisfy the constraints at start.time: the assembly problem and the initial
/// velocity problem (J. Garcia de Jalon, E. Bayo, 1994, ch. 3). Known ones are kept; of all solutions it
/// takes the one that Newton's method with steps of least length reaches from `start`, so velocities that
/// nothing determines stay as they are there. Positions that satisfy the constraints to rounding are left
/// untouched. Throws Error with the constraint that is farthest off if there is none.
State consistent_state(Model& model, State start, const Known& known);

/// The same of a mechanism at time t from its drawing, with what its description gives.
State initial_state(Mechanism& mechanism, double t);

}  // namespace tandem::mbs
