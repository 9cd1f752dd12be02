// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tandem/mbs/stepper.hpp"

namespace tandem::test {

/// Errors of q, v, a and lambda at the times of `exact`, evenly spaced from 0, all together, as an error at
/// one time may pass through zero. `steps` is a multiple of their number.
using StepperErrors = std::array<double, 4>;
inline StepperErrors errors(mbs::Stepper& stepper, mbs::State s, const std::vector<mbs::State>& exact,
                            int steps) {
  StepperErrors sum{};
  const double end = exact.back().time;
  const int each = steps / static_cast<int>(exact.size());
  s.a.setZero();
  stepper.start(s);
  for (int k = 1; k <= steps; ++k) {
    stepper.step(s, end / steps, k * end / steps);
    if (k % each != 0) continue;
    const mbs::State& there = exact[static_cast<std::size_t>(k / each - 1)];
    const StepperErrors squares = {(s.q - there.q).squaredNorm(), (s.v - there.v).squaredNorm(),
                                   (s.a - there.a).squaredNorm(), (s.lambda - there.lambda).squaredNorm()};
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += squares[i];
  }
  for (double& x : sum) x = std::sqrt(x);
  return sum;
}

inline double order_of(const std::string& integrator) {
  return integrator == "rk8" ? 8.0 : integrator == "rk4" ? 4.0 : 2.0;
}

/// Order 8 shows in long steps alone, in which the part of the next order is still seen.
inline double order_slack(double order) { return order > 4.0 ? 0.5 : 0.2; }

/// Theory within that for positions, velocities, accelerations and multipliers.
inline void expect_order(const StepperErrors& coarse, const StepperErrors& fine, double order) {
  const char* const names[] = {"q", "v", "a", "lambda"};
  for (std::size_t k = 0; k < coarse.size(); ++k)
    EXPECT_NEAR(std::log2(coarse[k] / fine[k]), order, order_slack(order))
        << names[k] << ", errors " << coarse[k] << " " << fine[k];
}

}  // namespace tandem::test
