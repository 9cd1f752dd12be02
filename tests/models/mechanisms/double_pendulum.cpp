// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/double_pendulum.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "mechanisms/motion.hpp"

namespace tandem::mechanisms {
namespace {

using TwoAngles = std::array<Real, 4>;  // a, b, a', b'

Vector2 accelerations(const TwoAngles& y) {
  const Real c = std::cos(y[0] - y[1]) / 2, s = std::sin(y[0] - y[1]) / 2;
  Eigen::Matrix<Real, 2, 2> mass;
  mass << 4.0L / 3, c, c, 1.0L / 3;
  const Vector2 force(-s * y[3] * y[3] - 1.5L * gravity * std::sin(y[0]),
                      s * y[2] * y[2] - 0.5L * gravity * std::sin(y[1]));
  return mass.inverse() * force;
}

TwoAngles double_rates(const TwoAngles& y) {
  const Vector2 acceleration = accelerations(y);
  return {y[2], y[3], acceleration[0], acceleration[1]};
}

}  // namespace

DoublePendulumState double_pendulum(double t) {
  constexpr Real level = std::numbers::pi_v<Real> / 2;
  const TwoAngles y = advance(TwoAngles{level, level, 0, 0}, t, double_rates);
  const Vector2 acceleration = accelerations(y);
  const Vector2 along_a(std::sin(y[0]), -std::cos(y[0])), across_a(std::cos(y[0]), std::sin(y[0]));
  const Vector2 along_b(std::sin(y[1]), -std::cos(y[1])), across_b(std::cos(y[1]), std::sin(y[1]));
  const Vector2 elbow_acceleration = acceleration[0] * across_a - y[2] * y[2] * along_a;
  const Vector2 tip_to_elbow = acceleration[1] * across_b - y[3] * y[3] * along_b;
  const Vector2 force = elbow_acceleration + tip_to_elbow / 2 + Vector2(0, gravity);  // times 1 kg
  const Vector2 elbow_velocity = y[2] * across_a, tip_velocity = elbow_velocity + y[3] * across_b;
  return {along_a.cast<double>(), (along_a + along_b).cast<double>(), elbow_velocity.cast<double>(),
          tip_velocity.cast<double>(), force.cast<double>()};
}

}  // namespace tandem::mechanisms
