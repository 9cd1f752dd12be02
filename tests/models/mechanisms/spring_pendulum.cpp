// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/spring_pendulum.hpp"

#include <cmath>
#include <numbers>

#include "mechanisms/motion.hpp"

namespace tandem::mechanisms {
namespace {

using Polar = std::array<Real, 4>;  // r, phi, r', phi'

Polar spring_rates(const Polar& y) {
  constexpr Real stiffness_per_mass = 100, free_length = 1;
  return {y[2], y[3],
          y[0] * y[3] * y[3] + gravity * std::cos(y[1]) - stiffness_per_mass * (y[0] - free_length),
          -(2 * y[2] * y[3] + gravity * std::sin(y[1])) / y[0]};
}

}  // namespace

SpringPendulumState spring_pendulum(double t) {
  const Polar y = advance(Polar{1.2L, std::numbers::pi_v<Real> / 2, 0, 0}, t, spring_rates);
  const Vector2 along(std::sin(y[1]), -std::cos(y[1])), across(std::cos(y[1]), std::sin(y[1]));
  const Vector2 velocity = y[2] * along + y[0] * y[3] * across;
  return {(y[0] * along).cast<double>(), velocity.cast<double>()};
}

}  // namespace tandem::mechanisms
