// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/transports/open.hpp"

namespace tandem::split_pendulum {

/// "split_pendulum.exact": the exact motion of the elbow of a double pendulum. Two uniform rods in the plane,
/// the upper one 1 m and 1 kg, hinged at the origin, the lower one at its end, the elbow; let go level at
/// rest, g = 9.81 m/s^2. From Lagrange's equations in the angles a, b of the rods from hanging down, with M,
/// m their masses and L, l their lengths,
///   (M/3 + m) L^2 a'' + m L l/2 cos(a - b) b'' = -m L l/2 sin(a - b) b'^2 - (M/2 + m) g L sin a,
///   m L l/2 cos(a - b) a'' + m l^2/3 b''       =  m L l/2 sin(a - b) a'^2 - m g l/2 sin b,
/// by the classical Runge-Kutta method; with its own step errors are below 1e-9 m in 2 s. Parameters:
/// `lower_mass` [kg] (0.1), `lower_length` [m] (0.5), `step` [s] (2.5e-4). Outputs: x, y [m].
void add_builtins(Builtins& builtins);

}  // namespace tandem::split_pendulum
