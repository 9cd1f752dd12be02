// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/formulations/index3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tandem/error.hpp"

namespace tandem::mbs {
namespace {

constexpr double gamma = 0.5;  // any other value of Newmark's gamma leaves order 1

[[noreturn]] void refuse(const std::string& setting, double found, const std::string& allowed) {
  throw Error(ErrorCode::invalid_argument, "index-3 formulation: " + setting + " is " +
                                               fmt::format("{}", found) + "; allowed is " + allowed);
}

double default_penalty(const Structure& s) {
  const auto& m = s.mass.values;
  return 1e7 * (m.empty() ? 1.0 : *std::max_element(m.begin(), m.end()));
}

void check(const Index3Settings& s) {
  if (!(s.penalty >= 0.0) || !std::isfinite(s.penalty)) refuse("penalty", s.penalty, "a number above 0");
  if (!(s.beta >= 1.0 / 12.0 - 1e-15 && s.beta <= 0.25)) refuse("beta", s.beta, "1/12 to 1/4");
  if (!(s.tolerance > 0.0)) refuse("tolerance", s.tolerance, "a number above 0");
  if (s.most_iterations < 1) refuse("most_iterations", s.most_iterations, "1 or more");
  if (s.projections < 1) refuse("projections", s.projections, "1 or more");
  if (s.multiplier_iterations < 1) refuse("multiplier_iterations", s.multiplier_iterations, "1 or more");
}

}  // namespace

Index3::Index3(Model& model, const Index3Settings& settings)
    : model_(model),
      structure_(model.structure()),
      settings_((check(settings), settings)),
      penalty_(settings.penalty > 0.0 ? settings.penalty : default_penalty(structure_)),
      tangent_(structure_, make_solver(settings.solver, MatrixKind::positive_definite)),
      matrices_(structure_),
      phi_(structure_.constraints),
      error_(structure_.constraints),
      shift_(structure_.constraints),
      force_(structure_.variables),
      residual_(structure_.variables) {}

void Index3::evaluate(const State& s) {
  model_.constraints(s.q.data(), phi_.data(), matrices_.jacobian.data());
}

/// Assembles and factorizes the tangent at a state.
void Index3::prepare(const State& s, const TangentFactors& factors) {
  if (structure_.stiffness.size() > 0)
    model_.force_derivatives(s.q.data(), s.v.data(), matrices_.stiffness.data(), matrices_.damping.data());
  tangent_.assemble(matrices_, factors);
  if (const int bad = tangent_.factorize(); bad >= 0)
    throw Error(ErrorCode::numerical, "the tangent matrix is singular at t = " + fmt::format("{}", s.time) +
                                          " s, at variable " + structure_.variable_names[bad]);
}

/// residual_ <- -beta h^2 alpha T^-1 Phi_q^T error_.
void Index3::solve_constraint_error() {
  error_ *= -scale_ * penalty_;
  residual_.setZero();
  add_product(structure_.jacobian, matrices_.jacobian.data(), error_.data(), residual_.data());
  tangent_.solve(residual_.data());
}

/// Augmented Lagrangian of index 1: (M + alpha Phi_q^T Phi_q) a = Q - Phi_q^T (lambda + alpha gamma), then
/// lambda <- lambda + alpha (Phi_q a + gamma), until the accelerations satisfy their constraints.
void Index3::start(State& s) {
  const int n = structure_.variables;
  model_.at_time(s.time);
  evaluate(s);
  prepare(s, {0.0, 0.0, penalty_});
  model_.forces(s.q.data(), s.v.data(), force_.data());
  s.lambda.setZero(structure_.constraints);
  Eigen::VectorXd gamma_term(structure_.constraints), rhs(structure_.constraints);
  model_.constraint_accelerations(s.q.data(), s.v.data(), gamma_term.data());
  for (int k = 0; k < settings_.most_iterations; ++k) {
    rhs = -(s.lambda + penalty_ * gamma_term);
    residual_ = force_;
    add_product(structure_.jacobian, matrices_.jacobian.data(), rhs.data(), residual_.data());
    tangent_.solve(residual_.data());
    const double change = (residual_ - s.a.head(n)).norm();
    s.a.head(n) = residual_;
    multiply_transposed(structure_.jacobian, matrices_.jacobian.data(), s.a.data(), error_.data());
    s.lambda += penalty_ * (error_ + gamma_term);
    if (change <= 1e-12 * s.a.norm()) break;
  }
}

int Index3::step(State& s, double h) {
  const int n = structure_.variables;
  double* const q = s.q.data();
  double* const v = s.v.data();
  const double* const a = s.a.data();
  for (int i = 0; i < n; ++i) q[i] += h * v[i] + 0.5 * h * h * a[i], v[i] += h * a[i];
  s.time += h;
  model_.at_time(s.time);
  if (!settings_.carry_multipliers) s.lambda.setZero();
  evaluate(s);
  for (int iteration = 1; iteration <= settings_.most_iterations; ++iteration) {
    const double correction = correct(s, h);
    evaluate(s);
    const bool done = correction < settings_.tolerance;
    if (done || iteration <= settings_.multiplier_iterations) s.lambda += penalty_ * phi_;
    if (!done) continue;
    project_velocities(s);
    project_accelerations(s);
    return iteration;
  }
  throw Error(ErrorCode::numerical, "no convergence at t = " + fmt::format("{}", s.time) + " s in " +
                                        std::to_string(settings_.most_iterations) + " iterations");
}

Eigen::VectorXd Index3::multipliers(const State& s) const {
  Eigen::VectorXd rate(structure_.constraints), gamma_term(structure_.constraints);
  multiply_transposed(structure_.jacobian, matrices_.jacobian.data(), s.a.data(), rate.data());
  model_.constraint_accelerations(s.q.data(), s.v.data(), gamma_term.data());
  return s.lambda + scale_ * penalty_ * (shift_ + rate + gamma_term);
}

/// One of Newton's iterations: the Euclidean norm of the change in q.
double Index3::correct(State& s, double h) {
  const double scale = scale_ = settings_.beta * h * h, to_v = gamma / (settings_.beta * h),
               to_a = 1.0 / scale;
  const int n = structure_.variables;
  prepare(s, {gamma * h, scale, scale * penalty_});
  model_.forces(s.q.data(), s.v.data(), force_.data());
  multiply_symmetric(structure_.mass, s.a.data(), residual_.data());
  residual_ -= force_;
  error_ = s.lambda + penalty_ * phi_;
  add_product(structure_.jacobian, matrices_.jacobian.data(), error_.data(), residual_.data());
  residual_ *= -scale;
  tangent_.solve(residual_.data());
  double* const q = s.q.data();
  double* const v = s.v.data();
  double* const a = s.a.data();
  double square = 0.0;
  for (int i = 0; i < n; ++i) {
    const double d = residual_[i];
    q[i] += d, v[i] += to_v * d, a[i] += to_a * d;
    square += d * d;
  }
  return std::sqrt(square);
}

void Index3::project_velocities(State& s) {
  model_.constraint_rates(s.q.data(), phi_.data());
  for (int k = 0; k < settings_.projections; ++k) {
    multiply_transposed(structure_.jacobian, matrices_.jacobian.data(), s.v.data(), error_.data());
    error_ += phi_;
    solve_constraint_error();
    s.v.head(structure_.variables) += residual_;
  }
}

void Index3::project_accelerations(State& s) {
  model_.constraint_accelerations(s.q.data(), s.v.data(), phi_.data());
  shift_.setZero();
  for (int k = 0; k < settings_.projections; ++k) {
    multiply_transposed(structure_.jacobian, matrices_.jacobian.data(), s.a.data(), error_.data());
    error_ += phi_;
    if (k > 0) shift_ += error_;
    solve_constraint_error();
    s.a.head(structure_.variables) += residual_;
  }
}

}  // namespace tandem::mbs
