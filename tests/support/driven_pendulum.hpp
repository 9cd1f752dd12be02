// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A model whose terms are written by hand, with every term that a model may have, and its exact motion.
#pragma once
#include <cmath>

#include "tandem/mbs/model.hpp"

namespace tandem::test {

/// A mass at (x, y) on a massless rod of 1 m, whose pivot moves as (amplitude sin(rate t), 0): a constraint
/// that depends on time. A spring pulls it to (1, 0), a damper slows it, and a force (input) pushes it.
class DrivenPendulum final : public mbs::Model {
 public:
  struct Parameters {
    double mass = 2.0, gravity = 9.81;   ///< [kg], [m/s^2]
    double spring = 5.0, damper = 0.3;   ///< [N/m], [N s/m]
    double amplitude = 0.2, rate = 3.0;  ///< of the pivot [m], [rad/s]
  };
  explicit DrivenPendulum(const Parameters& p) : p_(p) {
    structure_.coordinates = structure_.variables = 2;
    structure_.constraints = 1;
    structure_.mass = {mbs::Pattern(2, 2, {{0, 0}, {1, 1}}), {p.mass, p.mass}};
    structure_.jacobian = mbs::Pattern(2, 1, {{0, 0}, {1, 0}});
    structure_.stiffness = mbs::Pattern(2, 2, {{0, 0}, {1, 1}});
    structure_.variable_names = {"bob.x", "bob.y"};
    structure_.constraint_names = {"rod"};
  }

  const mbs::Structure& structure() const override { return structure_; }
  void at_time(double t) override {
    pivot_ = p_.amplitude * std::sin(p_.rate * t);
    pivot_rate_ = p_.amplitude * p_.rate * std::cos(p_.rate * t);
    pivot_acceleration_ = -p_.rate * p_.rate * pivot_;
  }
  /// Phi = (x - X(t))^2 + y^2 - 1.
  void constraints(const double* q, double* phi, double* jacobian) const override {
    const double x = q[0] - pivot_;
    phi[0] = x * x + q[1] * q[1] - 1.0;
    jacobian[0] = 2.0 * x;
    jacobian[1] = 2.0 * q[1];
  }
  void constraint_rates(const double* q, double* phi_t) const override {
    phi_t[0] = -2.0 * (q[0] - pivot_) * pivot_rate_;
  }
  void constraint_accelerations(const double* q, const double* v, double* gamma) const override {
    const double x_rate = v[0] - pivot_rate_;
    gamma[0] = 2.0 * (x_rate * x_rate + v[1] * v[1] - (q[0] - pivot_) * pivot_acceleration_);
  }
  void forces(const double* q, const double* v, double* force) const override {
    force[0] = -p_.spring * (q[0] - 1.0) - p_.damper * v[0] + input;
    force[1] = -p_.spring * q[1] - p_.damper * v[1] - p_.mass * p_.gravity;
  }
  void force_derivatives(const double*, const double*, double* k, double* c) const override {
    k[0] = k[1] = p_.spring;
    c[0] = c[1] = p_.damper;
  }
  double energy(const double* q, const double* v) const override {
    const double x = q[0] - 1.0;
    return 0.5 * p_.mass * (v[0] * v[0] + v[1] * v[1]) + p_.mass * p_.gravity * q[1] +
           0.5 * p_.spring * (x * x + q[1] * q[1]);
  }

  /// At an angle from hanging [rad] with a rate [rad/s]; accelerations and multiplier exact too:
  /// m r'' = F - 2 lambda n, r = (X, 0) + n, n = (sin angle, -cos angle).
  mbs::State at(double t, double angle, double rate) {
    at_time(t);
    const Eigen::Vector2d n(std::sin(angle), -std::cos(angle)), along(std::cos(angle), std::sin(angle));
    mbs::State s{t, n + Eigen::Vector2d(pivot_, 0.0), rate * along + Eigen::Vector2d(pivot_rate_, 0.0),
                 Eigen::Vector2d::Zero(), Eigen::VectorXd::Zero(1)};
    Eigen::Vector2d f;
    forces(s.q.data(), s.v.data(), f.data());
    const Eigen::Vector2d carried(pivot_acceleration_, 0.0);
    s.a = along * along.dot(f / p_.mass - carried) - rate * rate * n + carried;
    s.lambda[0] = 0.5 * n.dot(f - p_.mass * s.a);
    return s;
  }

  /// Exact after a time from at(0, angle, rate): the classical Runge-Kutta method on the angle, in steps of
  /// `finest` (errors of 1e-11 with 1e-3 s).
  mbs::State exact(double end, double angle, double rate, double finest = 1e-3) {
    const auto steps = std::max(1L, std::lround(end / finest));
    const double h = end / static_cast<double>(steps);
    const auto turn = [&](double t, double a, double r) {  // angular acceleration
      const mbs::State s = at(t, a, r);
      return std::cos(a) * (s.a[0] - pivot_acceleration_) + std::sin(a) * s.a[1];
    };
    for (long k = 0; k < steps; ++k) {
      const double t = static_cast<double>(k) * h, a1 = turn(t, angle, rate), r2 = rate + h / 2 * a1,
                   a2 = turn(t + h / 2, angle + h / 2 * rate, r2), r3 = rate + h / 2 * a2,
                   a3 = turn(t + h / 2, angle + h / 2 * r2, r3), r4 = rate + h * a3,
                   a4 = turn(t + h, angle + h * r3, r4);
      angle += h / 6 * (rate + 2 * r2 + 2 * r3 + r4);
      rate += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    return at(end, angle, rate);
  }

  double input = 0.0;  ///< force in x [N]

 private:
  Parameters p_;
  mbs::Structure structure_;
  double pivot_ = 0.0, pivot_rate_ = 0.0, pivot_acceleration_ = 0.0;
};

}  // namespace tandem::test
