// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

namespace tandem::mechanisms {

/// A uniform thin rod, 1 m and 1 kg, hinged at the origin: its free end [m], the velocity of that [m/s] and
/// the force of the hinge on the rod [N].
struct PendulumState {
  Eigen::Vector2d tip, velocity, reaction;
};

/// At the time t [s], from level (tip at (1, 0)) at rest at t = 0. With phi from hanging straight down
/// phi'' = -w^2 sin phi, w^2 = 3 g / (2 l), phi(0) = 90 degrees, of which the solution is
/// sin(phi/2) = k cd(w t, k), phi' = -2 w k k' sd(w t, k) with k = sin 45 degrees = k' (L. Landau, E.
/// Lifshitz, Mechanics, sect. 11; NIST Digital Library of Mathematical Functions, 22.19). Within 1e-14 in ten
/// seconds.
PendulumState pendulum(double t);

}  // namespace tandem::mechanisms
