// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

namespace tandem::test {

/// Where a point is [m] and its velocity [m/s].
struct Moving {
  Eigen::VectorXd at, velocity;
};

inline Moving resting(int dimension) {
  return {Eigen::VectorXd::Zero(dimension), Eigen::VectorXd::Zero(dimension)};
}

/// Kinetic energy of a uniform thin rod by the velocities of its ends, m/6 (a.a + a.b + b.b), and its
/// potential energy with 9.81 m/s^2 against the axis of that number [J].
inline double rod_energy(double mass, const Moving& a, const Moving& b, int up) {
  const double kinetic =
      mass / 6 * (a.velocity.squaredNorm() + a.velocity.dot(b.velocity) + b.velocity.squaredNorm());
  return kinetic + mass * 9.81 * (a.at[up] + b.at[up]) / 2;
}

/// The derivative of f by t, by Richardson's extrapolation of central differences over e and 2 e: its error
/// is e^4/30 times the fifth derivative.
template <class F>
auto slope(const F& f, double t, double e) {
  return ((8.0 * (f(t + e) - f(t - e)) - (f(t + 2 * e) - f(t - 2 * e))) / (12.0 * e)).eval();
}

}  // namespace tandem::test
