// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "slow_side.hpp"

namespace tandem::scenario {
namespace {

/// A constant force moves a spring's end by h^2 a / 2 (1 - c k h^2) in a step, k = stiffness / mass: the trapezoidal
/// rule, which takes the positions at both ends, has c = 1/4, an exact integrator 1/12.
bool takes_ends(double moved, double a, double k_h2, double h) {
  return (1.0 - moved / (0.5 * h * h * a)) / k_h2 > 1.0 / 6.0;
}

/// Where a force has moved it by y it accelerates by a1 = a - kappa y - delta v, at both times. kappa and delta are what a
/// mass of 1 hangs on.
Springs found_from(const SlowSide::Moved& m, double a, double mass) {
  const double determinant = m.y[0] * m.v[1] - m.y[1] * m.v[0], b0 = a - m.a[0], b1 = a - m.a[1];
  return {mass * (b0 * m.v[1] - b1 * m.v[0]) / determinant, mass * (b1 * m.y[0] - b0 * m.y[1]) / determinant,
          false, 0.0};
}

/// Where they are next to nothing, the acceleration of the force counts a bit.
double error_of(const Springs& s, const SlowSide::Moved& m, double a, double mass) {
  constexpr double rounding = 1e-5;
  double largest = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double found = a - m.a[k], told = (s.stiffness * m.y[k] + s.damping * m.v[k]) / mass;
    largest = std::max(largest, std::abs(told - found) /
                                    std::max({std::abs(found), std::abs(told), rounding * std::abs(a)}));
  }
  return largest;
}

}  // namespace

/// Short probes leave other modes of that side where they are.
Springs springs_of(SlowSide& slow, const Effective& stated) {
  const double force = slow.small_force();
  const ScalarPort& of = slow.displacement(0);
  const Begin free = slow.free();
  const double own = free.step,
               a = slow.derivative(slow.pushed(0, force), of, 2) - slow.derivative(free, of, 2);
  Springs all{stated.stiffness.value_or(0.0), stated.damping.value_or(0.0), false, 0.0};
  if (!stated.stiffness)
    all = found_from(slow.moved_by(force, slow.lands() ? own / 16.0 : own), a, force / a);
  const SlowSide::Moved moved = slow.moved_by(force, own);
  all.trapezoidal = takes_ends(moved.y[0], a, all.stiffness * a / force * own * own, own);
  all.error = error_of(all, moved, a, force / a);
  return all;
}

}  // namespace tandem::scenario
