// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "split_pendulum/model.hpp"

#include <gtest/gtest.h>

#include "mechanisms/double_pendulum.hpp"

namespace tandem::split_pendulum {
namespace {

/// Of equal rods there is another program, in extended precision. The errors are those of 4e3 steps of order
/// 4 with (2.5e-4 s)^4 and of the cubic between them, 2e-11 and 1e-13 m.
TEST(SplitPendulumTruth, IsThatOfTheDoublePendulumWithEqualRods) {
  const Truth truth(Rods{1.0, 0.0, 1.0}, 2.0);
  for (const double t : {0.0, 1e-4, 0.3, 0.77777, 1.2, 2.0})
    EXPECT_LT((truth.elbow(t) - mechanisms::double_pendulum(t).elbow).norm(), 1e-9) << t;
}

}  // namespace
}  // namespace tandem::split_pendulum
