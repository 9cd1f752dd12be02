// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/pendulum.hpp"

#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>

#include "mechanisms/motion.hpp"

namespace tandem::mechanisms {

PendulumState pendulum(double t) {
  const Real k = std::sqrt(0.5L), w = std::sqrt(1.5L * gravity), u = w * t;
  Real cn = 0;  // dn from sn, as that of Boost 1.74 loses digits where cn is small
  const Real sn = boost::math::jacobi_elliptic(k, u, &cn), dn = std::sqrt(1 - sn * sn / 2);
  const Real half_sine = k * cn / dn, half_cosine = k / dn;
  const Real sine = 2 * half_sine * half_cosine, cosine = 1 - 2 * half_sine * half_sine;
  const Real rate = -2 * w * k * k * sn / dn, acceleration = -w * w * sine;
  const Vector2 along(sine, -cosine), across(cosine, sine);
  const Vector2 centre_acceleration = 0.5L * (acceleration * across - rate * rate * along);
  const Vector2 reaction = centre_acceleration + Vector2(0, gravity);  // times 1 kg
  return {along.cast<double>(), (rate * across).cast<double>(), reaction.cast<double>()};
}

}  // namespace tandem::mechanisms
