// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/formulations/terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check_memory.hpp"
#include "checks.hpp"
#include "tandem/error.hpp"
#include "timed.hpp"

namespace tandem::mbs {
namespace {

double largest_value(const std::vector<double>& values) {
  return values.empty() ? 1.0 : *std::max_element(values.begin(), values.end());
}

/// The first entry of a vector that is not finite; the first of all where only the norm overflows.
int not_finite(const Eigen::VectorXd& x) {
  for (int i = 0; i < x.size(); ++i)
    if (!std::isfinite(x[i])) return i;
  return 0;
}

}  // namespace

Terms::Terms(Model& of, const std::string& solver, MatrixKind kind)
    : model(of),
      structure(of.structure()),
      tangent(structure, make_solver(solver, kind)),
      jacobian_rows(structure.jacobian),
      matrices(structure),
      phi(structure.constraints),
      gamma(phi),
      error(phi),
      weights(phi),
      force(structure.variables),
      inertia(force),
      correction(force),
      largest_mass(largest_value(structure.mass.values)),
      most_off_(mbs::most_off(structure)),
      solver_(solver),
      kind_(kind) {}

void Terms::constraints(const State& s) {
  const Timed timed(Task::dynamic_terms);
  model.constraints(s.q.data(), phi.data(), matrices.jacobian.data());
}

void Terms::refuse_lost(const State& s) const {
  refuse_lost_constraint(model, s, {phi.data(), most_off_.data(), matrices.jacobian.data()});
}

bool Terms::nearly_lost() {
  const auto borne = 0.1 * Eigen::Map<const Eigen::ArrayXd>(most_off_.data(), phi.size());
  error = phi.array() - phi.array().min(borne).max(-borne);
  return (error.array() != 0.0).any();
}

void Terms::forces(const State& s) {
  const Timed timed(Task::dynamic_terms);
  model.forces(s.q.data(), s.v.data(), force.data());
}

void Terms::assemble(const State& s, const TangentFactors& factors) {
  const Timed timed(Task::tangent);
  if (structure.stiffness.size() > 0)
    model.force_derivatives(s.q.data(), s.v.data(), matrices.stiffness.data(), matrices.damping.data());
  tangent.assemble(matrices, factors);
}

void Terms::factorize(const State& s, const TangentFactors& factors) {
  assemble(s, factors);
  const Timed timed(Task::factorization);
  int bad = tangent.factorize();
  definite = bad < 0;
  if (!definite && kind_ == MatrixKind::positive_definite && solver_ == "auto")
    bad = factorize_indefinite(factors);
  if (bad >= 0) refuse_singular(structure, "tangent matrix", bad, s.time);
}

void Terms::make_indefinite() {
  if (!indefinite_)
    indefinite_ = std::make_unique<Tangent>(structure, make_solver(solver_, MatrixKind::symmetric));
}

int Terms::factorize_indefinite(const TangentFactors& factors) {
  make_indefinite();
  indefinite_->assemble(matrices, factors);
  return indefinite_->factorize();
}

/// Of the tangent, after the number of numbers that it has; of the indefinite one, if there is one.
void Terms::remember(std::vector<double>& to) const {
  const std::size_t begin = to.size();
  to.push_back(0.0);
  tangent.remember(to);
  to[begin] = static_cast<double>(to.size() - begin - 1);
  if (indefinite_) indefinite_->remember(to);
}

void Terms::recall(std::span<const double> memory) {
  check_memory(!memory.empty() && memory[0] >= 0.0 && memory[0] <= static_cast<double>(memory.size() - 1));
  const auto first = static_cast<std::size_t>(memory[0]);
  tangent.recall(memory.subspan(1, first));
  const auto more = memory.subspan(1 + first);
  if (more.empty()) {
    indefinite_.reset();
  } else {
    make_indefinite();
    indefinite_->recall(more);
  }
  definite = true;
}

void Terms::solve(Eigen::VectorXd& x) { (definite ? tangent : *indefinite_).solve(x.data()); }

void Terms::residual(const State& s, const Eigen::VectorXd& by, double factor) {
  const Timed timed(Task::residual);
  multiply_symmetric(structure.mass, s.a.data(), inertia.data());
  jacobian_rows.multiply(matrices.jacobian.data(), by.data(), correction.data());
  correction = factor * (force - inertia - correction);
}

double Terms::correct(const State& s, const Eigen::VectorXd& by, double factor) {
  residual(s, by, factor);
  const Timed timed(Task::substitution);
  solve(correction);
  const double norm = correction.norm();
  if (std::isfinite(norm)) return norm;
  refuse_wrong_force(structure, force, s.time);
  throw Error(ErrorCode::numerical, fmt::format("the motion of {} is not finite at t = {} s",
                                                structure.variable_names[not_finite(correction)], s.time));
}

void Terms::violation(const Eigen::VectorXd& x, const Eigen::VectorXd& rhs) {
  multiply_transposed(structure.jacobian, matrices.jacobian.data(), x.data(), error.data());
  error += rhs;
}

void Terms::follow_correction() {
  weights = error;
  violation(correction, weights);
}

void Terms::project(Eigen::VectorXd& x, double weight) {
  error *= -weight;
  jacobian_rows.multiply(matrices.jacobian.data(), error.data(), correction.data());
  solve(correction);
  x.head(structure.variables) += correction;
}

int Terms::settle(State& s, double penalty, double tolerance, int most) {
  const double floor = force.norm() / largest_mass;
  double before = 0.0;
  for (int iteration = 1; iteration <= most; ++iteration) {
    weights = s.lambda + penalty * error;
    const double change = correct(s, weights, 1.0),
                 rate = iteration > 1 ? std::min(change / before, 1.0) : 1.0;
    s.a.head(structure.variables) += correction;
    follow_correction();
    s.lambda += penalty * error;
    if (change * rate <= tolerance * (s.a.norm() + floor)) return iteration;
    before = change;
  }
  return 0;
}

}  // namespace tandem::mbs
