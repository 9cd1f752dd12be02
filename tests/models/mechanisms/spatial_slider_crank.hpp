// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

namespace tandem::mechanisms {

/// The spatial slider-crank of the IFToMM library of computational benchmark problems (after E. Haug,
/// Computer Aided Kinematics and Dynamics of Mechanical Systems, 1989). A crank, A B, 0.08 m and 0.12 kg,
/// turns about the axis x through A (0, 0.1, 0.12) m; a rod, B C, 0.3 m and 0.5 kg, goes to a slider of 2 kg
/// on the x axis, with a spherical joint at B and a universal joint at C, of which one axis is x and the
/// other, `cross`, is the rod's, perpendicular to it. Centres are in the middle; inertia about them: crank
/// 1e-4 kg m^2 about x, rod 4e-3 kg m^2 across and 4e-4 kg m^2 along.
struct SpatialSliderCrankState {
  double angle, rate;                             ///< of the crank from +z, about +x [rad], [rad/s]
  Eigen::Vector3d crank_end, crank_end_velocity;  ///< B [m], [m/s]
  Eigen::Vector3d slider, slider_velocity;        ///< C [m], [m/s]
  Eigen::Vector3d cross;                          ///< the rod's axis of the universal joint, a unit vector
  Eigen::Vector3d rod_angular_velocity;           ///< [rad/s]
};

/// At the time t >= 0 [s], from angle 0 and 6 rad/s at t = 0; gravity along -z. With d from B to C, of length
/// one, and dots by the angle, the rod turns at d x d' + spin d, spin = (d x d')_x d_x / (1 - d_x^2), as
/// `cross` stays perpendicular to x. Lagrange's equation in the angle is integrated in extended precision.
/// Errs by less than 1e-12 in five seconds.
SpatialSliderCrankState spatial_slider_crank(double t);

}  // namespace tandem::mechanisms
