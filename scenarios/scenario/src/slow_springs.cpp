// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
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
          false};
}

}  // namespace

/// Short probes leave other modes of that side where they are.
Springs springs_of(SlowSide& slow, const Effective& stated) {
  const double force = slow.small_force();
  const ScalarPort& of = slow.displacement(0);
  const Begin free = slow.free();
  const double own = free.step,
               a = slow.derivative(slow.pushed(0, force), of, 2) - slow.derivative(free, of, 2);
  Springs all{stated.stiffness.value_or(0.0), stated.damping.value_or(0.0), false};
  if (!stated.stiffness)
    all = found_from(slow.moved_by(force, slow.lands() ? own / 16.0 : own), a, force / a);
  all.trapezoidal = takes_ends(slow.moved_by(force, own).y[0], a, all.stiffness * a / force * own * own, own);
  return all;
}

}  // namespace tandem::scenario
