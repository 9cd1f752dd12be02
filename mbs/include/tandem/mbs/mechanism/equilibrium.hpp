// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/mechanism/initial.hpp"

namespace tandem::mbs {

/// Where forces at rest balance beside the constraints, Q(q, 0) = Phi_q^T lambda and Phi = 0, with the inputs
/// that the model has, by Newton's method from `start` (J. Garcia de Jalon, E. Bayo, 1994, ch. 4), each step
/// or a part of it followed by the shortest way back to the constraints: it need not be stable. Where no step
/// makes the unbalanced forces smaller, they are followed as long as they do work. Known positions stay;
/// where nothing pulls back (a kart along the road) a coordinate stays as it is. A dense method: its time
/// grows by the cube of the variables, some 50 ms for 170. Throws Error with the variable that is pulled most
/// if there is none.
State equilibrium(Model& model, State start, const Known& known);

}  // namespace tandem::mbs
