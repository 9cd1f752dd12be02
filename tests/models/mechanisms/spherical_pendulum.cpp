// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/spherical_pendulum.hpp"

#include <cmath>
#include <numbers>

#include "mechanisms/motion.hpp"

namespace tandem::mechanisms {
namespace {

using Angles = std::array<Real, 3>;  // theta, phi, theta'

constexpr Real moment = 2;  // x y' - y x' at the start [m^2/s]

Angles spherical_rates(const Angles& y) {
  const Real s = std::sin(y[0]), c = std::cos(y[0]), azimuth_rate = moment / (s * s);
  return {y[2], azimuth_rate, azimuth_rate * azimuth_rate * s * c + 1.5L * gravity * s};
}

}  // namespace

SphericalPendulumState spherical_pendulum(double t) {
  const Angles y = advance(Angles{std::numbers::pi_v<Real> / 2, 0, 0}, t, spherical_rates),
               rate = spherical_rates(y);
  const Real s = std::sin(y[0]), c = std::cos(y[0]);
  const Vector3 outward(std::cos(y[1]), std::sin(y[1]), 0), onward(-outward[1], outward[0], 0);
  const Vector3 up(0, 0, 1), tip = s * outward + c * up;
  const Vector3 velocity = rate[0] * (c * outward - s * up) + rate[1] * s * onward;
  return {tip.cast<double>(), velocity.cast<double>()};
}

}  // namespace tandem::mechanisms
