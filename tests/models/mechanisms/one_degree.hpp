// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

#include "mechanisms/jet.hpp"

namespace tandem::mechanisms {

/// Lagrange's equation of a mechanism of one degree of freedom, J s'' + 1/2 (dJ/ds) s'^2 = Q, from the
/// kinetic energy 1/2 J(s) s'^2 and the generalized force Q: its coefficients at one s.
struct OneDegree {
  Real inertia = 0, inertia_slope = 0, force = 0;  ///< J, dJ/ds, Q

  Real acceleration(Real rate) const { return (force - inertia_slope * rate * rate / 2) / inertia; }

  /// Adds the kinetic energy 1/2 weight a'.b': a = b is the place of a mass, or of a body in the plane that
  /// turns a unit vector along it, with its moment of inertia as weight.
  template <class T>
  void add_product(const Jet<T>& a, const Jet<T>& b, Real weight) {
    inertia += weight * a.first.dot(b.first);
    inertia_slope += weight * (a.second.dot(b.first) + a.first.dot(b.second));
  }

  /// Adds a uniform thin rod, m/6 (a'.a' + a'.b' + b'.b') with its ends a and b, and its weight along -y.
  template <class T>
  void add_rod(const Jet<T>& a, const Jet<T>& b, Real mass) {
    add_product(a, a, mass / 3);
    add_product(a, b, mass / 3);
    add_product(b, b, mass / 3);
    force -= mass * gravity * (a.first[1] + b.first[1]) / 2;
  }
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
