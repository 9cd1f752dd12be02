// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "tandem/error.hpp"
#include "tandem/mbs/sparse/products.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {
namespace {

[[noreturn]] void fail(const std::string& sentence) { throw Error(ErrorCode::numerical, sentence); }

std::string constraints_of(const Structure& s, int variable) {
  std::vector<std::string> names;
  for (const auto& [row, column] : s.jacobian.entries())
    if (row == variable) names.push_back(s.constraint_names[column]);
  return names.empty() ? "in no constraint" : "in the constraints " + listed(names);
}

}  // namespace

void refuse_vanishing_row(const Structure& s, const double* jacobian, double time) {
  constexpr double zero = 1e-12;
  const ColumnSquares squares =
      column_squares(s.jacobian, jacobian);  // in each step: no name is looked for yet
  if (s.constraints == 0 || squares.least > zero * zero * squares.most) return;
  const int* const starts = s.jacobian.starts().data();
  const auto square = [&](int c) {
    return std::inner_product(jacobian + starts[c], jacobian + starts[c + 1], jacobian + starts[c], 0.0);
  };
  int at = 0;
  while (square(at) > squares.least) ++at;
  fail(fmt::format("the row of the Jacobian of constraint '{}' vanishes at t = {} s: it holds nothing there",
                   s.constraint_names[at], time));
}

void refuse_wrong_force(const Structure& s, const Eigen::VectorXd& force, double time) {
  for (int i = 0; i < force.size(); ++i)
    if (!std::isfinite(force[i]))
      fail(fmt::format("the force on {} is {} at t = {} s", s.variable_names[i], force[i], time));
}

void refuse_singular(const Structure& s, const char* matrix, int variable, double time) {
  fail(fmt::format("the {} is singular at t = {} s, at variable {}, which is {}", matrix, time,
                   s.variable_names[variable], constraints_of(s, variable)));
}

void refuse_unsettled(int iterations, double time) {
  fail(fmt::format("accelerations and multipliers have not settled at t = {} s in {} iterations", time,
                   iterations));
}

}  // namespace tandem::mbs
