// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

namespace tandem::mechanisms {

/// Two uniform thin rods, 1 m and 1 kg each, the first hinged at the origin, the second to its end, the
/// elbow: positions [m], velocities [m/s], and the force of the first rod on the second at the elbow [N].
struct DoublePendulumState {
  Eigen::Vector2d elbow, tip, elbow_velocity, tip_velocity, elbow_force;
};

/// At the time t >= 0 [s], from both level at rest at t = 0, elbow at (1, 0) and tip at (2, 0). Lagrange's
/// equations in the angles a, b of the rods from hanging straight down,
///   4/3 a'' + 1/2 cos(a - b) b'' = -1/2 sin(a - b) b'^2 - 3/2 g sin a,
///   1/2 cos(a - b) a'' + 1/3 b'' =  1/2 sin(a - b) a'^2 - 1/2 g sin b,
/// integrated in extended precision. The motion is chaotic: an error of the start grows 2e3-fold in ten
/// seconds and 3e7-fold in twenty. Errs by less than 1e-12 in ten seconds and 1e-8 in twenty.
DoublePendulumState double_pendulum(double t);

}  // namespace tandem::mechanisms
