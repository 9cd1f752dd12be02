// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/integrators/frequency.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/error.hpp"

namespace tandem::mbs {

double highest_frequency(SecondOrder& problem, const Motion& motion) {
  const double reach = 1e-6 * (1.0 + motion.y.norm());
  Eigen::VectorXd argument(problem.size()), y = argument, above = motion.a, below = motion.a;
  return std::sqrt(spectral_radius(argument, [&](Eigen::VectorXd& z) {
    y = motion.y + reach * z;
    problem.accelerations(motion.time, y.data(), motion.v.data(), above.data());
    y = motion.y - reach * z;
    problem.accelerations(motion.time, y.data(), motion.v.data(), below.data());
    z = (above - below) / (2.0 * reach);
  }));
}

double newmark_limit(double beta) { return beta < 0.25 ? 1.0 / std::sqrt(0.25 - beta) : HUGE_VAL; }

void refuse_unstable(const char* owner, double beta, double frequency, double t, double h) {
  const double limit = newmark_limit(beta);
  if (frequency * h > limit)
    throw Error(
        ErrorCode::numerical,
        fmt::format("{}: beta = {:.4g} is stable up to omega h = {:.4g}; at t = {} s the step is {} s and "
                    "the highest frequency {:.4g} rad/s, so it is {:.4g}; allowed are beta = 0.25 or a "
                    "step below {:.3g} s",
                    owner, beta, limit, t, h, frequency, frequency * h, limit / frequency));
}

double newmark_growth(double beta) {
  const double half = 0.5 / beta - 1.0;
  return half + std::sqrt(std::max(0.0, half * half - 1.0));
}

}  // namespace tandem::mbs
