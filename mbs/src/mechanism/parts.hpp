// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::mbs {

/// By coordinate and then by equation: those that share a number act on each other at once, through the mass
/// matrix or a constraint. The ground passes nothing on: a coordinate that does not move is alone.
std::vector<int> connected_parts(const Mechanism& mechanism);

/// By spring, force along a line and element: the coordinates of its points, or its own. What it does to them
/// follows from where they stand, and how fast they are, at once.
std::vector<std::vector<int>> force_groups(const Mechanism& mechanism);

/// The coordinates on which a force acts.
std::vector<int> places(const Mechanism& mechanism, const Force& force);

}  // namespace tandem::mbs
