// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/spherical_pendulum.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <numbers>

#include "rod_energy.hpp"

namespace tandem::mechanisms {
namespace {

constexpr double g = 9.81, moment = 2.0;

/// Height z of the tip: z'^2 = (v^2 - 3 g z)(1 - z^2) - h^2 with v = h = 2 has the roots low < 0 < high, so
/// z = low - low sn^2(w t + K), w = sqrt(3 g (high - low)) / 2, k^2 = -low / (high - low)
/// (E. Whittaker, Analytical Dynamics, sect. 55).
struct Height {
  double root = std::sqrt(16 + 36 * g * g);
  double low = (4 - root) / (6 * g), high = (4 + root) / (6 * g);
  double w = std::sqrt(3 * g * (high - low)) / 2, k = std::sqrt(-low / (high - low));
};

TEST(SphericalPendulumReference, ItsHeightIsAnEllipticFunction) {
  const Height f;
  for (double t = 0.0; t < 10.0; t += 0.31) {
    double cn = 0;
    const double sn = boost::math::jacobi_elliptic(f.k, f.w * t, &cn);
    const double cd_squared = cn * cn / (1 - f.k * f.k * sn * sn);
    EXPECT_NEAR(spherical_pendulum(t).tip[2], f.low * (1 - cd_squared), 1e-13) << t;
  }
}

/// From the highest to the lowest the azimuth grows by integral of h / (1 - z^2) dt, by partial fractions two
/// elliptic integrals of the third kind.
TEST(SphericalPendulumReference, ItsAzimuthGrowsByEllipticIntegrals) {
  const Height f;
  const double half_period = boost::math::ellint_1(f.k) / f.w;
  const double turn = moment / (2 * f.w) *
                      (boost::math::ellint_3(f.k, -f.low / (1 - f.low)) / (1 - f.low) +
                       boost::math::ellint_3(f.k, f.low / (1 + f.low)) / (1 + f.low));
  for (int n = 1; n <= 12; ++n) {
    const Eigen::Vector3d tip = spherical_pendulum(n * half_period).tip;
    EXPECT_NEAR(tip[2], n % 2 == 0 ? 0.0 : f.low, 1e-13) << n;
    EXPECT_NEAR(std::remainder(std::atan2(tip[1], tip[0]) - n * turn, 2 * std::numbers::pi), 0.0, 1e-12) << n;
  }
}

TEST(SphericalPendulumReference, KeepsItsLengthEnergyAndMomentAboutTheVertical) {
  for (double t = 0.0; t < 10.0; t += 0.31) {
    const SphericalPendulumState s = spherical_pendulum(t);
    EXPECT_NEAR(s.tip.norm(), 1.0, 1e-14);
    EXPECT_NEAR(test::rod_energy(1.0, test::resting(3), {s.tip, s.velocity}, 2), 4.0 / 6, 1e-12) << t;
    EXPECT_NEAR(s.tip.cross(s.velocity)[2], moment, 1e-13) << t;
  }
}

}  // namespace
}  // namespace tandem::mechanisms
