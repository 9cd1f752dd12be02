// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Models of one or two variables that have nothing but what a test of a limit case needs.
#pragma once
#include "tandem/mbs/model.hpp"

namespace tandem::test {

/// A mass that x = 0 holds, and (1 - t) y = 0 until t = 1 s.
class Fading final : public mbs::Model {
 public:
  Fading() {
    structure_.coordinates = structure_.variables = structure_.constraints = 2;
    structure_.mass = {mbs::Pattern(2, 2, {{0, 0}, {1, 1}}), {1.0, 1.0}};
    structure_.jacobian = mbs::Pattern(2, 2, {{0, 0}, {1, 1}});
    structure_.stiffness = mbs::Pattern(2, 2, {});
    structure_.variable_names = {"x", "y"};
    structure_.constraint_names = {"wall", "fading"};
  }
  const mbs::Structure& structure() const override { return structure_; }
  void at_time(double t) override { left_ = 1.0 - t; }
  void constraints(const double* q, double* phi, double* jacobian) const override {
    phi[0] = q[0], phi[1] = left_ * q[1];
    jacobian[0] = 1.0, jacobian[1] = left_;
  }
  void constraint_rates(const double* q, double* phi_t) const override { phi_t[0] = 0.0, phi_t[1] = -q[1]; }
  void constraint_accelerations(const double*, const double* v, double* gamma) const override {
    gamma[0] = 0.0, gamma[1] = -2.0 * v[1];
  }
  void forces(const double*, const double*, double* force) const override { force[0] = force[1] = 0.0; }
  void force_derivatives(const double*, const double*, double*, double*) const override {}
  double energy(const double*, const double* v) const override { return 0.5 * (v[0] * v[0] + v[1] * v[1]); }

 private:
  mbs::Structure structure_;
  double left_ = 1.0;
};

/// Free fall: no constraint at all. Second-order methods are exact for constant forces.
class Thrown final : public mbs::Model {
 public:
  Thrown() {
    structure_.coordinates = structure_.variables = 1;
    structure_.mass = {mbs::Pattern(1, 1, {{0, 0}}), {2.0}};
    structure_.jacobian = mbs::Pattern(1, 0, {});
    structure_.stiffness = mbs::Pattern(1, 1, {});
    structure_.variable_names = {"height"};
  }
  const mbs::Structure& structure() const override { return structure_; }
  void at_time(double) override {}
  void constraints(const double*, double*, double*) const override {}
  void constraint_rates(const double*, double*) const override {}
  void constraint_accelerations(const double*, const double*, double*) const override {}
  void forces(const double*, const double*, double* force) const override { force[0] = -6.0; }
  void force_derivatives(const double*, const double*, double*, double*) const override {}
  double energy(const double* q, const double* v) const override { return v[0] * v[0] + 6.0 * q[0]; }

 private:
  mbs::Structure structure_;
};

}  // namespace tandem::test
