// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

namespace tandem::mechanisms {

/// A uniform thin rod in space, 1 m and 1 kg, with one end fixed to the origin: its free end [m] and the
/// velocity of that [m/s]. It has no inertia about itself.
struct SphericalPendulumState {
  Eigen::Vector3d tip, velocity;
};

/// At the time t >= 0 [s], from tip (1, 0, 0) and velocity (0, 2, 0) at t = 0; gravity along -z. With the
/// angle theta from upright and the azimuth phi
///   theta'' = phi'^2 sin theta cos theta + 3/2 g sin theta,  phi' = 2 / sin^2 theta,
/// as the moment of momentum about z stays; integrated in extended precision. The rod never comes nearer to
/// hanging down than 20.9 degrees. Errs by less than 1e-13 in ten seconds.
SphericalPendulumState spherical_pendulum(double t);

}  // namespace tandem::mechanisms
