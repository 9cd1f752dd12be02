// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/formulations/stabilized.hpp"

#include <algorithm>

#include "settings.hpp"

namespace tandem::mbs {

Stabilized::Stabilized(const char* owner, Model& model, const Baumgarte& s)
    : terms_(model, s.solver, MatrixKind::positive_definite),
      alpha_(s.penalty > 0.0 ? s.penalty : 1e7 * terms_.largest_mass),
      rhs_(terms_.structure.constraints),
      with_velocities_(terms_.structure.coordinates),
      xi_(s.xi),
      omega_(s.omega) {
  Setting{owner, "penalty", s.penalty}.at_least(0.0, "a number above 0");
  Setting{owner, "xi", s.xi}.at_least(0.0, "0 or more");
  Setting{owner, "omega", s.omega}.at_least(0.0, "0 or more [rad/s]");
}

/// T, Q and Phi_q q'' + rhs at a state, in one product with Phi_q.
void Stabilized::prepare(const State& s) {
  terms_.model.at_time(s.time);
  terms_.constraints(s);
  terms_.factorize(s, {0.0, 0.0, alpha_});
  terms_.forces(s);
  terms_.model.constraint_accelerations(s.q.data(), s.v.data(), terms_.gamma.data());
  terms_.model.constraint_rates(s.q.data(), rhs_.data());
  const double damping = 2.0 * xi_ * omega_;
  rhs_ = terms_.gamma + damping * rhs_ + omega_ * omega_ * terms_.phi;
  with_velocities_ = s.a + damping * s.v;
  terms_.violation(with_velocities_, rhs_);
}

void Stabilized::accelerations(double t, const double* y, const double* v, double* a) {
  const int n = size();
  at_.time = t;
  std::copy_n(y, n, at_.q.data());
  std::copy_n(v, n, at_.v.data());
  std::copy_n(a, n, at_.a.data());
  prepare(at_);
  solve(at_);
  std::copy_n(at_.a.data(), n, a);
}

/// From accelerations that may be far off: once more takes off what rounding left.
void Stabilized::start(State& s) {
  s.lambda.setZero(terms_.structure.constraints);
  prepare(s);
  terms_.refuse_lost(s);
  solve(s);
  refresh(s);
}

bool Stabilized::begin(const State& s, Motion& motion) {
  const int n = size();
  at_ = s;
  motion.time = s.time;
  motion.y = s.q.head(n);
  motion.v = s.v.head(n);
  motion.a = s.a.head(n);
  return false;
}

void Stabilized::finish(const Motion&, State& s) {
  terms_.refuse_lost(at_);
  multipliers(at_);
  if (terms_.nearly_lost()) hold();
  s = at_;
}

/// With T and Phi_q of the last evaluation, which was there.
void Stabilized::hold() {
  terms_.project(at_.q, alpha_);
  refresh(at_);
}

void Stabilized::refresh(State& s) {
  prepare(s);
  solve(s);
  multipliers(s);
}

}  // namespace tandem::mbs
