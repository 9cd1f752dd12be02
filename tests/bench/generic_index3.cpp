// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/generic_index3.hpp"

#include <algorithm>

#include "tandem/error.hpp"

namespace tandem::bench {
namespace {

constexpr int most_iterations = 30, multiplier_iterations = 10;

Eigen::SparseMatrix<double> matrix(const mbs::Pattern& p, const double* values) {
  return Eigen::Map<const Eigen::SparseMatrix<double>>(p.rows(), p.columns(), p.size(), p.starts().data(),
                                                       p.indices().data(), values);
}

}  // namespace

GenericIndex3::GenericIndex3(mbs::Model& model, double penalty, double tolerance)
    : model_(model),
      penalty_(penalty),
      tolerance_(tolerance),
      jacobian_(static_cast<std::size_t>(model.structure().jacobian_values())),
      phi_(model.structure().constraints),
      gamma_(model.structure().constraints),
      force_(model.structure().variables) {
  const mbs::Structure& s = model.structure();
  mass_ = matrix(s.mass.pattern, s.mass.values.data());
  transposed_ = matrix(s.jacobian, jacobian_.data());
}

void GenericIndex3::constraints(const mbs::State& s) {
  model_.constraints(s.q.data(), phi_.data(), jacobian_.data());
  std::copy_n(jacobian_.data(), transposed_.nonZeros(), transposed_.valuePtr());
}

void GenericIndex3::start(mbs::State& s) {
  const int n = model_.structure().variables;
  model_.at_time(s.time);
  constraints(s);
  solver_.analyzePattern(tangent(penalty_));
  solver_.factorize(tangent(penalty_));
  model_.forces(s.q.data(), s.v.data(), force_.data());
  model_.constraint_accelerations(s.q.data(), s.v.data(), gamma_.data());
  Vector lambda = Vector::Zero(phi_.size());
  for (int k = 0; k < most_iterations; ++k) {
    s.a.head(n) = solver_.solve(force_ - transposed_ * (lambda + penalty_ * gamma_));
    lambda += penalty_ * (transposed_.transpose() * s.a.head(n) + gamma_);
  }
  s.lambda = lambda;
}

void GenericIndex3::refresh(mbs::State& s) { start(s); }

int GenericIndex3::step(mbs::State& s, double h, double t_end) {
  const int n = model_.structure().variables;
  s.q.head(n) += h * s.v.head(n) + 0.5 * h * h * s.a.head(n);
  s.v.head(n) += h * s.a.head(n);
  s.time = t_end;
  model_.at_time(t_end);
  s.lambda.setZero();
  constraints(s);
  for (int iteration = 1; iteration <= most_iterations; ++iteration) {
    const double weight = 0.25 * h * h * penalty_;
    const bool done = correct(s, h) < tolerance_;
    if (done) project_velocities(s, weight);
    constraints(s);
    if (done || iteration <= multiplier_iterations) s.lambda += penalty_ * phi_;
    if (!done) continue;
    project_accelerations(s, weight);
    return iteration;
  }
  throw Error(ErrorCode::numerical, "no convergence");
}

double GenericIndex3::correct(mbs::State& s, double h) {
  const int n = model_.structure().variables;
  const double scale = 0.25 * h * h;
  solver_.factorize(tangent(scale * penalty_));
  model_.forces(s.q.data(), s.v.data(), force_.data());
  const Vector residual = mass_ * s.a.head(n) - force_ + transposed_ * (s.lambda + penalty_ * phi_);
  const Vector dq = solver_.solve(-scale * residual);
  s.q.head(n) += dq;
  s.v.head(n) += 2.0 / h * dq;
  s.a.head(n) += 1.0 / scale * dq;
  return dq.norm();
}

void GenericIndex3::project_velocities(mbs::State& s, double weight) {
  const int n = model_.structure().variables;
  s.v.head(n) -= solver_.solve(weight * (transposed_ * (transposed_.transpose() * s.v.head(n))));
}

void GenericIndex3::project_accelerations(mbs::State& s, double weight) {
  const int n = model_.structure().variables;
  model_.constraint_accelerations(s.q.data(), s.v.data(), gamma_.data());
  const Vector error = transposed_.transpose() * s.a.head(n) + gamma_;
  s.a.head(n) -= solver_.solve(weight * (transposed_ * error));
  s.lambda += weight * (transposed_.transpose() * s.a.head(n) + gamma_);
}

}  // namespace tandem::bench
