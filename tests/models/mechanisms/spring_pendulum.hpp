// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

namespace tandem::mechanisms {

/// A point mass of 1 kg on a massless spring from the origin, 100 N/m, 1 m long when free: where the mass is
/// [m] and its velocity [m/s].
struct SpringPendulumState {
  Eigen::Vector2d position, velocity;
};

/// At the time t >= 0 [s], from (1.2, 0) at rest at t = 0. In the length r and the angle phi from hanging
/// down
///   r'' = r phi'^2 + g cos phi - (k/m) (r - 1 m),  phi'' = -(2 r' phi' + g sin phi) / r,
/// integrated in extended precision. Errs by less than 1e-13 in ten seconds.
SpringPendulumState spring_pendulum(double t);

}  // namespace tandem::mechanisms
