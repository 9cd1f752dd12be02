// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
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
  const int* const starts = s.jacobian.starts().data();
  const auto square = [&](int c) {
    double sum = 0.0;
    for (int k = starts[c]; k < starts[c + 1]; ++k) sum += jacobian[k] * jacobian[k];
    return sum;
  };
  double least = HUGE_VAL, most = 0.0;
  for (int c = 0; c < s.constraints; ++c) {  // in each step of every model: no name is looked for yet
    const double row = square(c);
    least = std::min(least, row);
    most = std::max(most, row);
  }
  if (s.constraints == 0 || least > zero * zero * most) return;
  int at = 0;
  while (square(at) > least) ++at;
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
