// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "split_pendulum/exact.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "mechanisms/double_pendulum.hpp"

namespace tandem::split_pendulum {
namespace {

/// Of equal rods there is another program, in extended precision. The errors are those of steps of order 4,
/// 2e-11 m with 2.5e-4 s.
TEST(SplitPendulumExact, IsTheDoublePendulumWithEqualRods) {
  Builtins builtins;
  add_builtins(builtins);
  const auto exact = open("builtin:split_pendulum.exact?lower_mass=1&lower_length=1", builtins);
  constexpr std::int64_t size = 6;
  std::vector<double> memory(8001 * size);
  Samples y(memory.data(), size, 8001);
  exact->initialize(0.0, 2.0, {}, y);
  exact->advance(2.0, false, {}, y);
  ASSERT_EQ(y.size(), 8001);
  for (const std::int64_t row : {0, 1, 1200, 3111, 4800, 8000}) {
    const auto values = y.values(row);
    const Eigen::Vector2d expected = mechanisms::double_pendulum(y.time(row)).elbow;
    EXPECT_LT((Eigen::Vector2d(values[0], values[1]) - expected).norm(), 1e-9) << row;
    if (row == 0 || row == 8000) continue;
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(values[2 + k],
                  (y.values(row + 1)[k] - y.values(row - 1)[k]) / 5e-4, 1e-5);
  }
}

}  // namespace
}  // namespace tandem::split_pendulum
