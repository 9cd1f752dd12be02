// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <array>

namespace tandem::mechanisms {

/// Andrews' squeezing mechanism: seven bodies in the plane without gravity, driven by a constant torque on
/// the crank K1. W. Schiehlen (ed.), Multibody Systems Handbook, Springer 1990, sect. 2.2; E. Hairer, G.
/// Wanner, Solving Ordinary Differential Equations II, sect. VII.7; Test Set for Initial Value Problem
/// Solvers, problem `andrews`, whence the numbers. Bodies by their joints: K1 O F, K2 F E, K3 B E D, K4 G E,
/// K5 A G, K6 H E, K7 A H; O, A, B, C are fixed, the spring is between C and D.
struct AndrewsParameters {
  using Real = long double;
  std::array<Real, 7> mass{0.04325L, 0.00365L, 0.02373L, 0.00706L, 0.07050L, 0.00706L, 0.05498L};  ///< [kg]
  /// About the centres [kg m^2].
  std::array<Real, 7> inertia{2.194e-6L, 4.410e-7L, 5.255e-6L, 5.667e-7L, 1.169e-5L, 5.667e-7L, 1.912e-5L};
  Real xa = -0.06934L, ya = -0.00227L, xb = -0.03635L, yb = 0.03273L, xc = 0.014L, yc = 0.072L;  ///< [m]
  Real rr = 0.007L, ra = 0.00092L;                 ///< K1: O F, from O to the centre [m]
  Real d = 0.028L, da = 0.0115L;                   ///< K2: F E, from F to the centre [m]
  Real ss = 0.035L, sa = 0.01874L, sb = 0.01043L;  ///< K3: B E; centre along B E and across, to the left [m]
  Real sc = 0.018L, sd = 0.02L;                    ///< K3: D along B E and across [m]
  Real e = 0.02L, ea = 0.01421L;                   ///< K4: G E, from E to the centre [m]
  Real zt = 0.04L, ta = 0.02308L, tb = 0.00916L;   ///< K5: A G; centre along A G and across, to the left [m]
  Real zf = 0.02L, fa = 0.01421L;                  ///< K6: H E, from E to the centre [m]
  Real u = 0.04L, ua = 0.01228L, ub = 0.00449L;    ///< K7: A H; centre along A H and across, to the right [m]
  Real stiffness = 4530.0L, free_length = 0.07785L;  ///< of the spring [N/m], [m]
  Real torque = 0.033L;                              ///< on K1 [N m]
};

/// The angles of the literature, in its order: beta, Theta, gamma, Phi, delta, Omega, epsilon [rad], with
/// their derivatives [rad/s], [rad/s^2]; and the moving joints with their velocities [m], [m/s]. Directions:
/// O F at beta, E F at beta + Theta, A G at delta, H E at Omega + epsilon; B E at gamma, G E at Phi + delta
/// and A H at epsilon, these three counted from -y.
struct AndrewsState {
  std::array<double, 7> angles, rates, accelerations;
  struct Joints {
    Eigen::Vector2d F, E, G, H, D;
  } joints, velocities;
};

/// At the time t >= 0 [s], from rest at Theta = 0, beta = -0.0617138900142764496358948458001. All joints
/// follow from beta by three meetings of circles; Lagrange's equation in beta is integrated in extended
/// precision. Errs by less than 1e-12 of the largest angle and rate in 0.03 s.
AndrewsState andrews(double t);

/// The state at 0.03 s as published with the test set: by the code PSIDE in Cray's double precision,
/// tolerances 1e-14.
struct AndrewsPublished {
  std::array<double, 7> angles{0.1581077119629904e+2,  -0.1575637105984298e+2, 0.4082224013073101e-1,
                               -0.5347301163226948e+0, 0.5244099658805304e+0,  0.5347301163226948e+0,
                               0.1048080741042263e+1};
  std::array<double, 7> rates{0.1139920302151208e+4, -0.1424379294994111e+4, 0.1103291221937134e+2,
                              0.1929337464421385e+2, 0.5735699284790808e+0,  -0.1929337464421385e+2,
                              0.3231791658026955e+0};
  std::array<double, 7> accelerations{-0.2463176316945196e+5, 0.5185037701610329e+5, 0.3241025686413781e+6,
                                      0.5667493645176213e+6,  0.1674362929479361e+5, -0.5667493645176222e+6,
                                      0.9826520791458422e+4};
};

}  // namespace tandem::mechanisms
