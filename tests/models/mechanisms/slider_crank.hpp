// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

namespace tandem::mechanisms {

/// A crank, 0.2 m and 0.5 kg, about the origin, and a connecting rod, 0.6 m and 1 kg, both uniform and thin,
/// to a slider on the x axis to the right, a point mass of 0.4 kg. The crank's angle from the x axis,
/// counter-clockwise, grows without end.
struct SliderCrankState {
  double angle, rate;                             ///< [rad], [rad/s]
  double slider, slider_velocity;                 ///< [m], [m/s]
  Eigen::Vector2d crank_end, crank_end_velocity;  ///< [m], [m/s]
};

/// At the time t >= 0 [s], from an angle of 45 degrees and 10 rad/s at t = 0. With the slider at
/// x = r cos angle + sqrt(l^2 - r^2 sin^2 angle) and rods of kinetic energy m/6 (a'.a' + a'.b' + b'.b'), a
/// and b their ends, the kinetic energy is 1/2 J angle'^2 with
///   J = m1 r^2/3 + m2/3 (r^2 - r sin(angle) dx + dx^2) + m3 dx^2,  dx = dx/d(angle),
/// the potential energy g (m1 + m2) r/2 sin angle; Lagrange's equation is integrated in extended precision.
/// Errs by less than 1e-12 in ten seconds.
SliderCrankState slider_crank(double t);

}  // namespace tandem::mechanisms
