// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Sampled subsystems that read others with a memory, in a ring: no schedule stands still in it. Two masses
// and two controllers: the first reads the first mass one period late and the second mass at once, and pushes
// the first; the second reads the first mass and pushes the second.
#include <gtest/gtest.h>

#include "sampled_scene.hpp"

namespace tandem::test {
namespace {

SampledScene ring(double h) {
  const auto controller = [](double gain, double period, double offset) {
    return Part{{matrix({{0.5}}), matrix({{0.2, 0.1}}), matrix({{1.0}}), matrix({{gain, 0.5 * gain}}),
                 VectorXd::Zero(1)},
                LinearController::Times{period, offset, 0.0}};
  };
  SampledScene scene;
  scene.parts = {oscillator(4.0, 0.1, 0.5), oscillator(5.0, 0.1, -0.3), controller(-2.0, 0.11, 0.013),
                 controller(-1.5, 0.17, 0.0)};
  scene.wires = {{0, 0, 2, 0, true},  {1, 0, 2, 1, false}, {2, 0, 0, 0, false},
                 {0, 0, 3, 0, false}, {1, 1, 3, 1, true},  {3, 0, 1, 0, false}};
  scene.sides = {{h}, {0.7 * h}, {}, {}};
  scene.t_stop = 2.0;
  return scene;
}

double largest_difference(const Recording::Rows& a, const Recording::Rows& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0.0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    most = std::max(most, std::abs(a[k][2] - b[k][2]));
  return most;
}

/// Both masses end steps where they are read, and what pushes them is held: nothing is extrapolated, and what
/// is left is rounding.
TEST(LaggedRings, RunToTheSameMotionInEachSchedule) {
  const auto expected = run(ring(0.001), "fastest-first");
  for (const std::string& schedule : schedules)
    for (const double h : {0.04, 0.013}) {
      const auto rows = run(ring(h), schedule);
      for (const std::size_t controller : {2, 3})
        EXPECT_LT(largest_difference(rows[controller], expected[controller]), 1e-12) << schedule << " " << h;
    }
}

}  // namespace
}  // namespace tandem::test
