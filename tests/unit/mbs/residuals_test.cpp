// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/residuals.hpp"

#include <gtest/gtest.h>

#include "driven_pendulum.hpp"

namespace tandem::mbs {
namespace {

/// At the height 0, right of the pivot: Phi_q = (2, 0). Rounding of numbers up to 20.
TEST(Residuals, AreWhatAStateMissesOfItsConstraints) {
  test::DrivenPendulum pendulum({});
  State s = pendulum.at(0.7, std::acos(0.0), 0.5);
  EXPECT_LT(residuals(pendulum, s).position, 1e-14);
  EXPECT_LT(residuals(pendulum, s).velocity, 1e-14);
  EXPECT_LT(residuals(pendulum, s).acceleration, 1e-13);
  s.a[0] -= 0.25;
  EXPECT_NEAR(residuals(pendulum, s).acceleration, 0.5, 1e-13);
  s.v[0] += 0.125;
  EXPECT_NEAR(residuals(pendulum, s).velocity, 0.25, 1e-14);
  s.q[0] += 0.5;
  EXPECT_NEAR(residuals(pendulum, s).position, 1.25, 1e-14);
}

}  // namespace
}  // namespace tandem::mbs
