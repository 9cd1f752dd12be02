// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/slider_crank.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rod_energy.hpp"

namespace tandem::mechanisms {
namespace {

using test::Moving;

/// Energy [J] at an angle and rate, the slider's velocity from the rod's length: (c - s).(c' - s') = 0.
double energy(double angle, double rate) {
  const Eigen::Vector2d c(0.2 * std::cos(angle), 0.2 * std::sin(angle)), v(-rate * c[1], rate * c[0]);
  const double place = c[0] + std::sqrt(0.36 - c[1] * c[1]);
  const double slider_rate = v[0] + v[1] * c[1] / (c[0] - place);
  const Moving crank_end{c, v}, slider{Eigen::Vector2d(place, 0), Eigen::Vector2d(slider_rate, 0)};
  return test::rod_energy(0.5, test::resting(2), crank_end, 1) + test::rod_energy(1.0, crank_end, slider, 1) +
         0.2 * slider_rate * slider_rate;
}

TEST(SliderCrankReference, KeepsTheRodsLengthAndTheEnergy) {
  const double start = energy(std::numbers::pi / 4, 10.0);
  for (double t = 0.0; t < 10.0; t += 0.61) {
    const SliderCrankState s = slider_crank(t);
    const Eigen::Vector2d slider(s.slider, 0), slider_velocity(s.slider_velocity, 0);
    EXPECT_NEAR((s.crank_end - slider).norm(), 0.6, 1e-15);
    EXPECT_NEAR((s.crank_end - slider).dot(s.crank_end_velocity - slider_velocity), 0.0, 1e-14);
    EXPECT_NEAR(energy(s.angle, s.rate), start, 1e-12) << t;
    const Moving crank_end{s.crank_end, s.crank_end_velocity}, end{slider, slider_velocity};
    EXPECT_NEAR(test::rod_energy(0.5, test::resting(2), crank_end, 1) +
                    test::rod_energy(1.0, crank_end, end, 1) + 0.2 * s.slider_velocity * s.slider_velocity,
                start, 1e-12);
  }
}

/// The time of a revolution is the integral of d(angle) / rate, the rate from the energy: the trapezoidal
/// rule over a whole period converges faster than any power.
TEST(SliderCrankReference, TurnsOnceInTheTimeThatItsEnergyGives) {
  const double start = energy(std::numbers::pi / 4, 10.0);
  constexpr int points = 400;
  double revolution = 0.0;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points, potential = energy(angle, 0.0);
    const double half_inertia = energy(angle, 1.0) - potential;
    revolution += 2 * std::numbers::pi / points * std::sqrt(half_inertia / (start - potential));
  }
  for (const int n : {1, 5, 18}) {
    const SliderCrankState s = slider_crank(n * revolution);
    EXPECT_NEAR(s.angle, std::numbers::pi / 4 + 2 * std::numbers::pi * n, 1e-12) << n;
    EXPECT_NEAR(s.rate, 10.0, 1e-12) << n;
  }
}

}  // namespace
}  // namespace tandem::mechanisms
