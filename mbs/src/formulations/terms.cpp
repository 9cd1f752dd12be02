// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/formulations/terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {
namespace {

[[noreturn]] void fail(const std::string& sentence) { throw Error(ErrorCode::numerical, sentence); }

double largest(const std::vector<double>& values) {
  return values.empty() ? 1.0 : *std::max_element(values.begin(), values.end());
}

/// "constraints a, b", or that there are none.
std::string constraints_of(const Structure& s, int variable) {
  std::vector<std::string> names;
  for (const auto& [row, column] : s.jacobian.entries())
    if (row == variable) names.push_back(s.constraint_names[column]);
  return names.empty() ? "in no constraint" : "in the constraints " + listed(names);
}

/// The first variable at which a vector is not finite; -1 if there is none.
int not_finite(const Eigen::VectorXd& x) {
  for (int i = 0; i < x.size(); ++i)
    if (!std::isfinite(x[i])) return i;
  return -1;
}

}  // namespace

Terms::Terms(Model& of, const std::string& solver)
    : model(of),
      structure(of.structure()),
      tangent(structure, make_solver(solver, MatrixKind::positive_definite)),
      matrices(structure),
      phi(structure.constraints),
      gamma(phi),
      error(phi),
      weights(phi),
      force(structure.variables),
      correction(force),
      largest_mass(largest(structure.mass.values)) {}

void Terms::constraints(const State& s) {
  model.constraints(s.q.data(), phi.data(), matrices.jacobian.data());
}

void Terms::refuse_vanishing(const State& s) const {
  constexpr double zero = 1e-12;
  const int* const starts = structure.jacobian.starts().data();
  double least = HUGE_VAL, most = 0.0;
  int at = 0;
  for (int c = 0; c < structure.constraints; ++c) {
    double square = 0.0;
    for (int k = starts[c]; k < starts[c + 1]; ++k) square += matrices.jacobian[k] * matrices.jacobian[k];
    if (square < least) least = square, at = c;
    most = std::max(most, square);
  }
  if (structure.constraints > 0 && least <= zero * zero * most)
    fail(
        fmt::format("the row of the Jacobian of constraint '{}' vanishes at t = {} s: it holds nothing there",
                    structure.constraint_names[at], s.time));
}

void Terms::forces(const State& s) { model.forces(s.q.data(), s.v.data(), force.data()); }

void Terms::factorize(const State& s, const TangentFactors& factors) {
  if (structure.stiffness.size() > 0)
    model.force_derivatives(s.q.data(), s.v.data(), matrices.stiffness.data(), matrices.damping.data());
  tangent.assemble(matrices, factors);
  if (const int bad = tangent.factorize(); bad >= 0)
    fail(fmt::format("the tangent matrix is singular at t = {} s, at variable {}, which is {}", s.time,
                     structure.variable_names[bad], constraints_of(structure, bad)));
}

double Terms::correct(const State& s, const Eigen::VectorXd& by, double factor) {
  multiply_symmetric(structure.mass, s.a.data(), correction.data());
  correction -= force;
  add_product(structure.jacobian, matrices.jacobian.data(), by.data(), correction.data());
  correction *= -factor;
  tangent.solve(correction.data());
  const double norm = correction.norm();
  if (std::isfinite(norm)) return norm;
  if (const int i = not_finite(force); i >= 0)
    fail(fmt::format("the force on {} is {} at t = {} s", structure.variable_names[i], force[i], s.time));
  fail(fmt::format("the motion of {} is not finite at t = {} s",
                   structure.variable_names[std::max(0, not_finite(correction))], s.time));
}

void Terms::violation(const Eigen::VectorXd& x, const Eigen::VectorXd& rhs) {
  multiply_transposed(structure.jacobian, matrices.jacobian.data(), x.data(), error.data());
  error += rhs;
}

void Terms::project(Eigen::VectorXd& x, double weight) {
  error *= -weight;
  correction.setZero();
  add_product(structure.jacobian, matrices.jacobian.data(), error.data(), correction.data());
  tangent.solve(correction.data());
  x.head(structure.variables) += correction;
}

int Terms::settle(State& s, const Eigen::VectorXd& rhs, double penalty, double tolerance, int most) {
  const double floor = force.norm() / largest_mass;
  violation(s.a, rhs);
  for (int iteration = 1; iteration <= most; ++iteration) {
    weights = s.lambda + penalty * error;
    const double change = correct(s, weights, 1.0);
    s.a.head(structure.variables) += correction;
    violation(s.a, rhs);
    s.lambda += penalty * error;
    if (change <= tolerance * (s.a.norm() + floor)) return iteration;
  }
  return 0;
}

}  // namespace tandem::mbs
