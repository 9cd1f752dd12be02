// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The slow sides of docs/impulse_coupling.md.
#pragma once
#include <algorithm>
#include <numbers>

#include "slow_sides.hpp"

namespace tandem::test {

constexpr double fast_frequency = 2.0 * std::numbers::pi;

/// Masses of the two-mass test at a frequency ratio, of a mass ratio m1 / me.
struct Light {
  double ratio, mass_ratio = 0.01;
  double w2() const { return fast_frequency / ratio; }
  double m1() const { return (1.0 + mass_ratio) / (fast_frequency * fast_frequency - w2() * w2()); }
  double me() const { return m1() / mass_ratio; }
  double k() const { return w2() * w2() * me(); }
};

inline VectorXd vec(std::initializer_list<double> numbers) {
  VectorXd v(static_cast<Eigen::Index>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), v.data());
  return v;
}

/// Constant M and K, with one displacement q[0] at y0 for the shape q.
inline SlowEquations linear(const MatrixXd& m, const MatrixXd& k, const VectorXd& q, double damping = 0.0) {
  return {[m](const VectorXd&) { return m; },
          [k, damping](const VectorXd& at, const VectorXd& u) { return VectorXd(-k * at - damping * u); },
          [](const VectorXd& at) { return VectorXd(at.head(1)); },
          [](const VectorXd& at) { return MatrixXd(MatrixXd::Identity(1, at.size())); },
          q,
          0.0 * q};
}

inline SlowEquations damped(const Light& of, double ratio) {
  return linear(MatrixXd::Constant(1, 1, of.me()), MatrixXd::Constant(1, 1, of.k()), vec({10.0}),
                2.0 * ratio * of.me() * of.w2());
}

/// The lowest of five masses in a row has w2; starts in that mode.
inline SlowEquations chain(const Light& of) {
  MatrixXd k = 2.0 * MatrixXd::Identity(5, 5);
  k(0, 0) = 1.0;
  for (int i = 0; i < 4; ++i) k(i, i + 1) = k(i + 1, i) = -1.0;
  VectorXd q(5);
  for (int i = 0; i < 5; ++i)
    q[i] = 10.0 * std::cos((i + 0.5) * std::numbers::pi / 11.0) / std::cos(std::numbers::pi / 22.0);
  const double lowest = 2.0 - 2.0 * std::cos(std::numbers::pi / 11.0);
  return linear(of.me() * MatrixXd::Identity(5, 5), of.k() / lowest * k, q);
}

/// A mass on one nine times as heavy, by a spring of `part` times the slow frequency.
inline SlowEquations inner(const Light& of, double part) {
  const double c = part * part * 0.9 * of.k();
  MatrixXd m = of.me() * MatrixXd::Identity(2, 2), k(2, 2);
  m(1, 1) *= 9.0;
  k << c, -c, -c, c + 10.0 * of.k();
  return linear(m, k, vec({10.0, 10.0}));
}

inline SlowEquations duffing(const Light& of, double beta, double by) {
  SlowEquations all = linear(MatrixXd::Constant(1, 1, of.me()), MatrixXd::Zero(1, 1), vec({10.0}));
  all.force = [k = of.k() / by, beta](const VectorXd& q, const VectorXd&) {
    return vec({-k * (q[0] + beta * q[0] * q[0] * q[0])});
  };
  return all;
}

inline SlowEquations pendulum(const Light& of) {
  const double l = 10.0 / std::sin(std::numbers::pi / 3.0), g = of.w2() * of.w2() * l, me = of.me();
  return {[=](const VectorXd&) { return MatrixXd::Constant(1, 1, me * l * l); },
          [=](const VectorXd& q, const VectorXd&) { return vec({-me * g * l * std::sin(q[0])}); },
          [=](const VectorXd& q) { return vec({l * std::sin(q[0])}); },
          [=](const VectorXd& q) { return MatrixXd::Constant(1, 1, l * std::cos(q[0])); },
          vec({std::numbers::pi / 3.0}),
          vec({0.0})};
}

inline SlowEquations double_pendulum(const Light& of) {
  const double l = 10.0, g = 20.0 * of.w2() * of.w2(), me = of.me();
  return {[=](const VectorXd& q) {
            MatrixXd m(2, 2);
            const double c = std::cos(q[0] - q[1]);
            m << 5.0, c, c, 1.0;
            return MatrixXd(me * l * l * m);
          },
          [=](const VectorXd& q, const VectorXd& u) {
            const double s = std::sin(q[0] - q[1]);
            return vec({-me * l * (l * s * u[1] * u[1] + 5.0 * g * std::sin(q[0])),
                        me * l * (l * s * u[0] * u[0] - g * std::sin(q[1]))});
          },
          [=](const VectorXd& q) { return vec({l * (std::sin(q[0]) + std::sin(q[1]))}); },
          [=](const VectorXd& q) {
            MatrixXd j(1, 2);
            j << l * std::cos(q[0]), l * std::cos(q[1]);
            return j;
          },
          vec({0.6, 0.9}),
          vec({0.0, 0.0})};
}

/// An inertia from 0.5 to 1.5.
inline SlowEquations rotor(const Light& of) {
  const double me = of.me(), k = of.k();
  return {
      [=](const VectorXd& q) { return MatrixXd::Constant(1, 1, me * (1.0 + 0.5 * std::cos(2.0 * q[0]))); },
      [=](const VectorXd& q, const VectorXd& u) {
        return vec({-k * q[0] + 0.5 * me * std::sin(2.0 * q[0]) * u[0] * u[0]});
      },
      [](const VectorXd& q) { return q; },
      [](const VectorXd&) { return MatrixXd::Identity(1, 1); },
      vec({1.2}),
      vec({0.0})};
}

/// It heaves and pitches on two springs, with a link at each end.
inline SlowEquations bar(const Light& of) {
  MatrixXd m = 2.0 * of.me() * MatrixXd::Identity(2, 2), k = 2.0 * of.k() * MatrixXd::Identity(2, 2), j(2, 2);
  m(1, 1) /= 3.0, k(1, 1) *= 1.7 * 1.7 / 3.0;
  j << 1.0, -1.0, 1.0, 1.0;
  SlowEquations all = linear(m, k, vec({10.0, 3.0}));
  all.displacement = [j](const VectorXd& q) { return VectorXd(j * q); };
  all.jacobian = [j](const VectorXd&) { return j; };
  return all;
}

}  // namespace tandem::test
