// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <array>

namespace tandem::mechanisms {

/// Bricard's mechanism of six revolute joints, problem A04 of the IFToMM library of computational benchmark
/// problems (M. Gonzalez, D. Dopico, U. Lugris, J. Cuadrado, Multibody System Dynamics 16, 2006, 179-190):
/// five uniform thin rods, 1 m and 1 kg each, P0 P1 to P4 P5, P0 and P5 on the ground; each rod perpendicular
/// to its two joints' axes and those to each other. One degree of freedom, where counting gives none.
struct BricardState {
  std::array<Eigen::Vector3d, 6> points, velocities;  ///< P0 to P5 [m], [m/s]
  std::array<Eigen::Vector3d, 6> axes;                ///< of the joints there, unit vectors
};

/// At the time t >= 0 [s], from rest along the edges of a cube: P0 (0,0,0), P1 (1,0,0), P2 (1,-1,0), P3
/// (1,-1,1), P4 (0,-1,1), P5 (0,0,1), axes y, z, x, y, z, x; gravity along -y. P0, P2, P4 and P1, P3, P5 stay
/// equilateral triangles of radii a and b about a common normal, h apart; the rods' length gives a^2 + b^2 -
/// a b + h^2 = 1, the axes a b = 2/3, so h = sin(s)/sqrt 3, a - b = cos(s)/sqrt 3, a + b = sqrt(3 - h^2) for
/// one angle s. Lagrange's equation in s is integrated in extended precision. Errs by less than 1e-12 in ten
/// seconds.
BricardState bricard(double t);

}  // namespace tandem::mechanisms
