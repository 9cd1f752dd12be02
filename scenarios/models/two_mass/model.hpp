// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/transports/parameters.hpp"

namespace tandem::two_mass {

/// What the two-mass three-spring test is set by. Mode 1 is the fast one (frequency 1 Hz), mode 2 the slow
/// one.
struct Settings {
  double frequency_ratio = 30.0;  ///< omega1 / omega2, above 1
  double c11 = 1.0;               ///< amplitude of x1 in mode 1 [m]
  double c11_over_c13 = 0.1;
  double c11_over_c23 = 0.1;
  double c23_over_c21 = -1000.0;
  double k2 = 1.0;                 ///< coupling spring [N/m]
  double phase1 = 0.0;             ///< of mode 1 at t = 0 [rad]
  double phase2 = 0.0;             ///< of mode 2 at t = 0 [rad]
  double steps_per_cycle = 100.0;  ///< own steps of each side per cycle of its own mode

  /// Takes the members by name.
  static Settings from(Parameters& parameters);
  static Words words();
};

struct Motion {
  double x1, v1, x2, v2;  ///< [m], [m/s]
};

/// k1 joins mass 1 to the wall, k2 the two masses, k3 mass 2 to the other wall:
///   m1 x1'' = -(k1+k2) x1 + k2 x2,   m2 x2'' = k2 x1 - (k2+k3) x2,
/// with the motion x1 = C11 cos(w1 t + p1) + C13 cos(w2 t + p2), x2 = C21 cos(w1 t + p1) + C23 cos(w2 t +
/// p2). A mode with x1/x2 = r has k1 + k2 - w^2 m1 = k2/r and k2 + k3 - w^2 m2 = k2 r; the two modes give the
/// four constants.
struct Model {
  double m1, m2, k1, k2, k3;  ///< [kg], [N/m]
  double omega1, omega2;      ///< [rad/s]
  double c11, c13, c21, c23;  ///< [m]
  double phase1, phase2;      ///< [rad]
  double h1, h2;              ///< own steps of the fast and the slow side [s]

  /// Throws Error naming the setting, and the range in which all constants are positive.
  explicit Model(const Settings& settings);

  Motion exact(double t) const;
  /// Kinetic and potential energy [J].
  double energy(const Motion& m) const;
};

}  // namespace tandem::two_mass
