// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A model whose terms are written by hand.
#pragma once
#include "tandem/mbs/model.hpp"
#include "tandem/signal.hpp"

namespace example {

/// A mass at (x, y) on a massless rod of 1 m about the origin. A spring without a length of its own pulls it
/// to (0, -1), and a force to the right.
class Pendulum final : public tandem::mbs::Model {
 public:
  static constexpr double mass = 2.0, gravity = 9.81, spring = 5.0;  // [kg], [m/s^2], [N/m]

  Pendulum() {
    using tandem::mbs::Pattern;
    structure_.coordinates = structure_.variables = 2;
    structure_.constraints = 1;
    structure_.mass = {Pattern(2, 2, {{0, 0}, {1, 1}}), {mass, mass}};
    structure_.jacobian = Pattern(2, 1, {{0, 0}, {1, 0}});
    structure_.stiffness = Pattern(2, 2, {{0, 0}, {1, 1}});
    structure_.variable_names = {"x", "y"};
    structure_.constraint_names = {"rod"};
  }

  const tandem::mbs::Structure& structure() const override { return structure_; }
  void at_time(double t) override {
    if (signal) push = signal->value(t);
  }
  /// Phi = x^2 + y^2 - 1, and its derivatives by x and y.
  void constraints(const double* q, double* phi, double* jacobian) const override {
    phi[0] = q[0] * q[0] + q[1] * q[1] - 1.0;
    jacobian[0] = 2.0 * q[0];
    jacobian[1] = 2.0 * q[1];
  }
  void constraint_rates(const double*, double* phi_t) const override { phi_t[0] = 0.0; }
  /// Phi'' = 2 x x'' + 2 y y'' + gamma.
  void constraint_accelerations(const double*, const double* v, double* gamma) const override {
    gamma[0] = 2.0 * (v[0] * v[0] + v[1] * v[1]);
  }
  void forces(const double* q, const double*, double* force) const override {
    force[0] = -spring * q[0] + push;
    force[1] = -spring * (q[1] + 1.0) - mass * gravity;
  }
  /// K = -dQ/dq, C = -dQ/dq'.
  void force_derivatives(const double*, const double*, double* k, double* c) const override {
    k[0] = k[1] = spring;
    c[0] = c[1] = 0.0;
  }
  double energy(const double* q, const double* v) const override {
    const double y = q[1] + 1.0;
    return 0.5 * mass * (v[0] * v[0] + v[1] * v[1]) + mass * gravity * q[1] +
           0.5 * spring * (q[0] * q[0] + y * y);
  }

  /// At rest, level to the right; accelerations and multiplier are for Stepper::start() to find.
  static tandem::mbs::State level(double t) {
    return {t, Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(),
            Eigen::VectorXd::Zero(1)};
  }

  double push = 0.0;                       ///< [N]
  const tandem::Signal* signal = nullptr;  ///< what `push` follows; none: it stays

 private:
  tandem::mbs::Structure structure_;
};

}  // namespace example
