// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::mbs {

/// Coordinates, by their place in q, whose values at the start are known.
struct Known {
  struct Value {
    int coordinate;
    double value;
    std::string where = {};  ///< a file and line, or nothing
  };
  std::vector<Value> positions, velocities;
};

/// Positions and velocities that satisfy the constraints at start.time: the assembly problem and the initial
/// velocity problem (J. Garcia de Jalon, E. Bayo, 1994, ch. 3). Known ones are kept; of all solutions it
/// takes the one that Newton's method with steps of least length reaches from `start`, so velocities that
/// nothing determines stay as they are there. Where `start` has no gradient along what may move, it is pushed
/// aside, by a tenth of the error at most, to the same side in every run. Positions that satisfy the
/// constraints to rounding are left untouched. Throws Error with what is known and the constraint that is
/// farthest off if there is none.
State consistent_state(Model& model, State start, const Known& known);

/// The same of a mechanism at time t from its drawing, with what its description gives.
State initial_state(Mechanism& mechanism, double t);

/// A constraint that can't hold beside the others and the given positions.
struct Contradiction {
  int constraint;
  double off;  ///< how far it is off where the assembly comes nearest (Model::off)
};
/// The positions of initial_state(), or where the assembly comes nearest and what contradicts there.
struct Assembled {
  State state;
  std::vector<Contradiction> contradictions;  ///< none if it is assembled
};
Assembled assembled(Mechanism& mechanism, double t);

}  // namespace tandem::mbs
