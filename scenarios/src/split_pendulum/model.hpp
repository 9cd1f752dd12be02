// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace tandem::split_pendulum {

/// Two uniform rods in the plane, the upper one 1 m and 1 kg, hinged at the origin, the lower one at its end,
/// the elbow; let go level at rest, g = 9.81 m/s^2.
struct Rods {
  double lower_mass = 0.1;    ///< [kg]
  double carried_mass = 0.0;  ///< of the lower rod, carried by the upper one at the elbow [kg]
  double lower_length = 0.5;  ///< [m]
};

/// The upper rod as the text of a mechanism file: inputs Fx, Fy [N], forces on the elbow, outputs x, y of it
/// [m]. With a carried mass m_c it has that at the elbow besides, and inputs ax, ay [m/s^2], the elbow's
/// acceleration as the lower rod has it, by which it takes that mass off again: M a + m_c a = F + m_c
/// a_lower, the weight of m_c taken off too.
std::string upper_text(const Rods& rods);
/// The lower rod: inputs x, y [m], the elbow's motion; outputs Rx, Ry [N], the force of its support on it,
/// and ax, ay [m/s^2].
std::string lower_text(const Rods& rods);
/// Both in one mechanism, outputs x, y.
std::string monolithic_text(const Rods& rods);

/// The exact motion of the elbow, from Lagrange's equations in the angles a, b of the rods from hanging down,
/// with M, m their masses and L, l their lengths,
///   (M/3 + m) L^2 a'' + m L l/2 cos(a - b) b'' = -m L l/2 sin(a - b) b'^2 - (M/2 + m) g L sin a,
///   m L l/2 cos(a - b) a'' + m l^2/3 b''       =  m L l/2 sin(a - b) a'^2 - m g l/2 sin b,
/// by the classical Runge-Kutta method in steps of 0.25 ms, Hermite's cubic between them: errors below 1e-9
/// m.
class Truth {
 public:
  Truth(const Rods& rods, double t_stop);
  Eigen::Vector2d elbow(double t) const;

 private:
  std::vector<std::array<double, 4>> nodes_;  ///< a, b, a', b'
};

}  // namespace tandem::split_pendulum
