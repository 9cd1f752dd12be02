// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

#include "mechanisms/motion.hpp"

namespace tandem::mechanisms {

/// Lagrange's equation of a mechanism of one degree of freedom, J s'' + 1/2 (dJ/ds) s'^2 = Q, from the
/// kinetic energy 1/2 J(s) s'^2 and the generalized force Q: its coefficients at one s.
struct OneDegree {
  Real inertia = 0, inertia_slope = 0, force = 0;  ///< J, dJ/ds, Q

  Real acceleration(Real rate) const { return (force - inertia_slope * rate * rate / 2) / inertia; }
};

/// s and s' at the time t >= 0 [s] from those at 0; coefficients(s) gives OneDegree.
template <class Coefficients>
std::array<Real, 2> advance_one_degree(std::array<Real, 2> start, double t,
                                       const Coefficients& coefficients) {
  return advance(start, t, [&](const std::array<Real, 2>& y) {
    return std::array<Real, 2>{y[1], coefficients(y[0]).acceleration(y[1])};
  });
}

}  // namespace tandem::mechanisms
