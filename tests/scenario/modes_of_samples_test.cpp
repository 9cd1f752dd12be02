// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Modes of systems in which subsystems sample, against matrix exponentials.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sampled_loop.hpp"
#include "tandem/stability/modes.hpp"

namespace tandem::modes_of_samples_tests {
namespace {

using namespace test;

/// Over one period of the controller: real part and modulus of what each mode is multiplied by.
std::vector<std::array<double, 2>> multipliers(const std::vector<stability::Mode>& modes, double period) {
  std::vector<std::array<double, 2>> all;
  for (const auto& mode : modes) {
    const double modulus = std::exp(mode.rate * period);
    all.push_back({modulus * std::cos(2.0 * std::numbers::pi * mode.frequency * period), modulus});
  }
  std::ranges::sort(all);
  return all;
}

std::vector<std::array<double, 2>> multipliers(const MatrixXd& map) {
  std::vector<std::array<double, 2>> all;
  const Eigen::VectorXcd values = map.eigenvalues();
  for (const auto value : values)
    if (value.imag() >= 0.0 && std::abs(value) > 1e-4) all.push_back({value.real(), std::abs(value)});
  std::ranges::sort(all);
  return all;
}

/// A side that is exact for held forces leaves nothing to a scheme: its modes are the true ones, whose eigenvalues are those
/// of matrix exponentials from instant to instant.
TEST(StabilityOfSamples, ModesAreThoseOfTheMatrixExponentials) {
  std::mt19937_64 random(13);
  for (int k = 0; k < 40; ++k) {
    const Gains gains = gains_by_chance(random, k, 0.1, k % 4 == 1 ? 1.0 : 2.7);
    const double period = gains.period;
    const Scratch folder;
    const auto one =
        scene_of(folder, {part_of_period(k) * period}, 0.0, k % 5 == 0 ? "parallel" : "slowest-first", 5.0);
    const auto found = stability::stability(one, with_controller(gains));
    ASSERT_EQ(found.unknown, "") << k;
    for (const auto& mode : found.modes) {
      EXPECT_GT(mode.likeness, 0.999) << k;
      EXPECT_NEAR(mode.growth, std::exp(mode.rate * found.step.period), 1e-7) << k;
      EXPECT_NEAR(mode.scheme_frequency, mode.frequency, 1e-7 / period) << k;
    }
    if (gains.latency > period) continue;  // more outputs wait than the map of matrix exponentials has
    const auto here = multipliers(found.modes, period), expected = multipliers(exact_map(gains));
    ASSERT_EQ(here.size(), expected.size()) << k;
    for (std::size_t i = 0; i < here.size(); ++i)
      for (std::size_t j = 0; j < 2; ++j) EXPECT_NEAR(here[i][j], expected[i][j], 1e-7) << k;
  }
}

/// Slow against what the controller does the mode is that of the oscillator with the controller's gains in it.
TEST(StabilityOfSamples, AFastControllerIsASpringAndADamper) {
  const Scratch folder;
  const auto one = scene_of(folder, {0.01}, 0.0, "slowest-first", 5.0);
  const auto found = stability::stability(one, with_controller({3.0, 0.6, 0.0, 0.001, 0.0, 0.0}));
  ASSERT_EQ(found.unknown, "");
  const auto& mode = found.modes.front();
  EXPECT_NEAR(mode.frequency, std::sqrt(4.0 - 0.16) / (2.0 * std::numbers::pi), 1e-3);
  EXPECT_NEAR(mode.damping, 0.2, 1e-3);
  EXPECT_EQ(found.mostly(mode), "side1.x, side1.v");
}

}  // namespace
}  // namespace tandem::modes_of_samples_tests
