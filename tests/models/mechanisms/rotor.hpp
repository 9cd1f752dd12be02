// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

namespace tandem::mechanisms {

/// A rigid body of 1 kg free to turn about its centre of mass, the origin. It begins with its principal axes
/// at e1 = (cos tilt, 0, -sin tilt), e2 = (0, 1, 0), e3 = (sin tilt, 0, cos tilt) and with a moment of
/// momentum of 2 kg m^2/s along z, which stays.
struct RotorState {
  Eigen::Matrix3d axes;              ///< columns e1, e2, e3
  Eigen::Vector3d angular_velocity;  ///< in space [rad/s]
};

/// A body of revolution, inertia 0.3, 0.3, 0.5 kg m^2 and tilt 0.4 rad, at any time t [s]: e3 goes round z at
/// the rate L / I1 while the body turns about e3 at L cos(tilt) (1/I3 - 1/I1) besides (L. Landau, E.
/// Lifshitz, Mechanics, sect. 33). Within rounding.
RotorState rotor(double t);

/// A body of three different inertias, 0.3, 0.4, 0.5 kg m^2, and tilt 0.6 rad, at the time t >= 0 [s]: near
/// the separatrix, so that it sways far from e3 and back. Components of the angular velocity by Jacobi's
/// elliptic functions, the azimuth of e3 by quadrature (L. Landau, E. Lifshitz, Mechanics, sect. 37). Within
/// 1e-13 in ten seconds.
RotorState asymmetric_rotor(double t);

}  // namespace tandem::mechanisms
