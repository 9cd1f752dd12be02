// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass/model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "refusal.hpp"

namespace tandem::two_mass {
namespace {

using test::refuses;

/// Figures of the specification, to its six digits.
TEST(TwoMassModel, HasTheConstantsOfFrequencyRatioThirty) {
  const Model m(Settings{.frequency_ratio = 30.0});
  EXPECT_NEAR(m.m1, 0.0256121, 5e-8);
  EXPECT_NEAR(m.m2, 2.56121, 5e-6);
  EXPECT_NEAR(m.k1, 0.00112347, 5e-9);
  EXPECT_NEAR(m.k2, 1.0, 0.0);
  EXPECT_NEAR(m.k3, 0.112347, 5e-7);
  EXPECT_NEAR(m.exact(0.0).x1, 11.0, 1e-12);
  EXPECT_NEAR(m.exact(0.0).x2, 9.99, 1e-12);
  EXPECT_EQ(m.h1, 0.01);
  EXPECT_NEAR(m.h2, 0.3, 1e-15);
}

/// m x'' = F along the exact motion, x'' by a central difference of the exact velocity over 2e-4 s: its error
/// is e^2/6 (2 pi)^4 11 = 2.9e-5 m/s^2 at most beside 430, and rounding's 1e-10.
TEST(TwoMassModel, ItsMotionObeysNewtonsLaw) {
  for (const double ratio : {1.5, 7.0, 30.7, 1000.0})
    for (const double t : {0.0, 0.123, 17.3}) {
      const Model m(Settings{.frequency_ratio = ratio, .phase1 = 0.8, .phase2 = 0.3});
      constexpr double e = 1e-4;
      const Motion before = m.exact(t - e), now = m.exact(t), after = m.exact(t + e);
      const double a1 = (after.v1 - before.v1) / (2.0 * e), a2 = (after.v2 - before.v2) / (2.0 * e);
      EXPECT_NEAR(m.m1 * a1, -(m.k1 + m.k2) * now.x1 + m.k2 * now.x2, 1e-4 * m.m1) << ratio;
      EXPECT_NEAR(m.m2 * a2, m.k2 * now.x1 - (m.k2 + m.k3) * now.x2, 1e-4 * m.m2) << ratio;
      EXPECT_NEAR((after.x1 - before.x1) / (2.0 * e), now.v1, 1e-4);
      EXPECT_NEAR((after.x2 - before.x2) / (2.0 * e), now.v2, 1e-4);
      EXPECT_NEAR(m.energy(now) / m.energy(m.exact(0.0)), 1.0, 1e-12);
    }
}

/// At frequency ratio 1 + s, k1 and k3 change their sign within the ratios of amplitudes that are allowed.
TEST(TwoMassModel, IsRefusedWhereAConstantWouldNotBePositive) {
  const auto refused = [](const Settings& s, const std::vector<std::string>& texts) {
    return refuses(ErrorCode::invalid_argument, texts, [&] { Model{s}; });
  };
  EXPECT_TRUE(refused({.frequency_ratio = 1.0}, {"frequency_ratio is 1; allowed is above 1"}));
  EXPECT_TRUE(refused({.frequency_ratio = 1e300}, {"frequency_ratio is 1e+300", "up to 1e6"}));
  EXPECT_TRUE(refused({.k2 = -1e-9}, {"k2 is -1e-09; allowed is above 0 N/m"}));
  EXPECT_TRUE(refused({.frequency_ratio = 30.0, .c11_over_c13 = 2.0}, {"k1 and k3 are positive"}));
  EXPECT_TRUE(refused({.steps_per_cycle = 0.0}, {"steps_per_cycle is 0"}));
  EXPECT_TRUE(refused({.c11 = std::nan("")}, {"c11 is nan"}));
}

}  // namespace
}  // namespace tandem::two_mass
