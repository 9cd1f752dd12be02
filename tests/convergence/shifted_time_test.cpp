// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A run that starts at another time is the same run, but for the rounding of times.
#include <gtest/gtest.h>

#include <cmath>

#include "sampled_scene.hpp"

namespace tandem::test {
namespace {

/// Two masses on springs that push each other by their positions, and a controller of the second that pushes
/// the first, every `period` [s]; 0: there is none.
SampledScene pair_of_masses(double ratio, double period, const std::string& how) {
  SampledScene scene{{oscillator(6.0, 0.05, 0.5), oscillator(4.0, 0.03, 1.0)},
                     {{1, 0, 0, 0}, {0, 0, 1, 0}},
                     {{0.013 / ratio, Method::rk4_split, how}, {0.013, Method::rk4_split, how}},
                     0.0,
                     4.0};
  for (Part& part : scene.parts) part.system.b = matrix({{0.0, 0.0}, {2.0, 1.0}});
  for (Part& part : scene.parts) part.system.d = MatrixXd::Zero(2, 2);
  if (period == 0.0) return scene;
  const auto one = [](double value) { return MatrixXd::Constant(1, 1, value); };
  scene.parts.push_back(
      {{one(0.9), one(0.1), one(-0.5), one(-0.5), VectorXd::Zero(1)}, {{period, 0.3 * period}}});
  scene.sides.push_back({});
  scene.wires.push_back({1, 0, 2, 0});
  scene.wires.push_back({2, 0, 0, 1});
  return scene;
}

class ShiftedTime : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Starts, ShiftedTime, testing::Values(0.1, -1.3, 100.1, 1e5));

/// Times are rounded by up to eps |t|, which shifts what lies between two nodes by as much; values change by
/// up to some 10 a second. A round more or less would be seen: it changes values by 1e-6 and more.
TEST_P(ShiftedTime, ChangesNothingBeyondRounding) {
  for (const std::string& schedule : schedules)
    for (const std::string how : {"lagrange0", "lagrange1", "lagrange3", "least_squares1_2"})
      for (const double ratio : {1.0, 7.0, 31.4159})
        for (const double period : {0.0, 0.05}) {
          SampledScene scene = pair_of_masses(ratio, period, how);
          const auto expected = run(scene, schedule);
          scene.t_start += GetParam();
          scene.t_stop += GetParam();
          const auto shifted = run(scene, schedule);
          double largest = 0.0;
          for (std::size_t who = 0; who < expected.size(); ++who) {
            ASSERT_EQ(shifted[who].size(), expected[who].size()) << schedule << " " << how << " " << ratio;
            for (std::size_t row = 0; row < expected[who].size(); ++row)
              for (std::size_t k = 2; k < expected[who][row].size(); ++k)
                largest = std::max(largest, std::abs(shifted[who][row][k] - expected[who][row][k]));
          }
          EXPECT_LT(largest, 1e-12 * (1.0 + 1e3 * std::abs(GetParam())))
              << schedule << " " << how << " " << ratio << " " << period;
        }
}

}  // namespace
}  // namespace tandem::test
