// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "tandem/error.hpp"
#include "tandem/mbs/sparse/products.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {
namespace {

constexpr double zero = 1e-12;

[[noreturn]] void fail(const std::string& sentence) { throw Error(ErrorCode::numerical, sentence); }

std::string constraints_of(const Structure& s, int variable) {
  std::vector<std::string> names;
  for (const auto& [row, column] : s.jacobian.entries())
    if (row == variable) names.push_back(s.constraint_names[column]);
  return names.empty() ? "in no constraint" : "in the constraints " + listed(names);
}

/// Of both numbers so many digits, three at least, that their sizes differ.
std::array<std::string, 2> figures_that_differ(double value, double limit) {
  for (int digits = 3;; ++digits) {
    const auto text = [=](double x) { return fmt::format("{:.{}g}", x, digits); };
    if (digits == 17 || text(std::abs(value)) != text(limit)) return {text(value), text(limit)};
  }
}

/// "off by 0.02 m, allowed is 0.005 m". Where an angle is off by more than a quarter of a turn, what is
/// allowed is told for a little of Phi.
std::string how_far_off(const Model& model, int c, const double* q, const Constraints& at) {
  const Off off = model.off(c, q, at.phi[c]);
  const double most = std::copysign(at.most[c], at.phi[c]);
  const double allowed = std::min(std::abs(model.off(c, q, most).now), std::abs(off.per_phi * most));
  const std::string unit = model.structure().unit_of(c);
  const auto [now, most_now] = figures_that_differ(off.now, allowed);
  return fmt::format("off by {}{}, allowed is {}{}", now, unit, most_now, unit);
}

}  // namespace

std::vector<double> most_off(const Structure& s) {
  std::vector<double> most = s.constraint_sizes;
  if (most.empty()) most.assign(static_cast<std::size_t>(s.constraints), 1.0);
  for (double& size : most) size *= 0.01;
  return most;
}

/// In each step: no name is looked for before something is wrong.
void refuse_lost_constraint(const Model& model, const State& state, const Constraints& at) {
  const Structure& s = model.structure();
  const ColumnSquares squares = column_squares(s.jacobian, at.jacobian);
  const double least = zero * zero * squares.most;
  const Eigen::Map<const Eigen::ArrayXd> phi(at.phi, s.constraints), most(at.most, s.constraints);
  if (s.constraints == 0 || (squares.least > least && (phi.abs() - most).maxCoeff() <= 0.0)) return;
  const int* const starts = s.jacobian.starts().data();
  for (int c = 0; c < s.constraints; ++c) {
    const double* const row = at.jacobian + starts[c];
    const double square = std::inner_product(row, at.jacobian + starts[c + 1], row, 0.0);
    if (square <= least)
      fail(fmt::format(
          "the row of the Jacobian of constraint '{}' vanishes at t = {} s: it holds nothing there",
          s.constraint_names[c], state.time));
    if (std::abs(at.phi[c]) > at.most[c])
      fail(fmt::format(
          "constraint '{}' is lost at t = {} s: it is {}; a greater penalty, more iterations or shorter "
          "steps hold it",
          s.constraint_names[c], state.time, how_far_off(model, c, state.q.data(), at)));
  }
}

void refuse_wrong_force(const Structure& s, const Eigen::VectorXd& force, double time) {
  for (int i = 0; i < force.size(); ++i)
    if (!std::isfinite(force[i]))
      fail(fmt::format("the force on {} is {} at t = {} s", s.variable_names[i], force[i], time));
}

void refuse_singular(const Structure& s, const char* matrix, int variable, double time) {
  fail(fmt::format(
      "the {} is singular at t = {} s (or not positive definite, if its solver needs that), at "
      "variable {}, which is {}{}",
      matrix, time, s.variable_names[variable], constraints_of(s, variable),
      s.stiffness.size() > 0 ? "; too long a step for the springs and forces does that too" : ""));
}

void refuse_unsettled(int iterations, double time) {
  fail(fmt::format("accelerations and multipliers have not settled at t = {} s in {} iterations", time,
                   iterations));
}

}  // namespace tandem::mbs
