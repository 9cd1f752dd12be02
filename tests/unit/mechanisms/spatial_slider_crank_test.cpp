// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/spatial_slider_crank.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "rod_energy.hpp"

namespace tandem::mechanisms {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d crank_end(double angle) { return {0, 0.1 - 0.08 * std::sin(angle), 0.12 + 0.08 * std::cos(angle)}; }

Vector3d slider(double angle) { return {std::sqrt(0.09 - crank_end(angle).squaredNorm()), 0, 0}; }

/// Along the rod, the axis of the joint, and the third.
Matrix3d frame(double angle) {
  const Vector3d along = (slider(angle) - crank_end(angle)) / 0.3, cross = Vector3d::UnitX().cross(along);
  return (Matrix3d() << along, cross.normalized(), along.cross(cross.normalized())).finished();
}

/// The angular velocity in W = R' R^T.
Vector3d vector_of(const Matrix3d& W) { return {W(2, 1), W(0, 2), W(1, 0)}; }

double energy(const Vector3d& rod_turn, const Vector3d& along, const Vector3d& b, const Vector3d& b_rate,
              const Vector3d& c_rate) {
  const double spin = rod_turn.dot(along), crank_rate_squared = b_rate.squaredNorm() / 0.0064;
  return 0.5 * (1e-4 + 0.12 * 0.0016) * crank_rate_squared + 0.25 * ((b_rate + c_rate) / 2).squaredNorm() +
         2e-3 * (rod_turn.squaredNorm() - spin * spin) + 2e-4 * spin * spin + c_rate.squaredNorm() +
         9.81 * (0.12 * (0.12 + b[2]) / 2 + 0.5 * b[2] / 2);
}

TEST(SpatialSliderCrankReference, KeepsRodJointsAndEnergy) {
  double start = 0.0;
  for (double t = 0.0; t < 5.0; t += 0.37) {
    const SpatialSliderCrankState s = spatial_slider_crank(t);
    const Vector3d along = (s.slider - s.crank_end) / 0.3;
    EXPECT_NEAR(along.norm(), 1.0, 1e-15) << t;
    EXPECT_NEAR((s.crank_end - crank_end(s.angle)).norm(), 0.0, 1e-14) << t;
    EXPECT_NEAR(s.cross.dot(along), 0.0, 1e-15) << t;
    EXPECT_EQ(s.cross[0], 0.0) << t;
    EXPECT_NEAR(s.rod_angular_velocity.cross(s.cross)[0], 0.0, 1e-14) << t;  // and stays so
    EXPECT_NEAR((0.3 * s.rod_angular_velocity.cross(along) - s.slider_velocity + s.crank_end_velocity).norm(),
                0.0, 1e-14)
        << t;
    const double now =
        energy(s.rod_angular_velocity, along, s.crank_end, s.crank_end_velocity, s.slider_velocity);
    if (t == 0.0) start = now;
    EXPECT_NEAR(now, start, 1e-13) << t;
  }
}

TEST(SpatialSliderCrankReference, ItsRodTurnsWithTheAngularVelocityGiven) {
  for (const double t : {0.0, 0.27, 3.1}) {
    const SpatialSliderCrankState s = spatial_slider_crank(t);
    const Matrix3d W = test::slope(frame, s.angle, 1e-3) * frame(s.angle).transpose();
    EXPECT_NEAR((s.rate * vector_of(W) - s.rod_angular_velocity).norm(), 0.0, 1e-9) << t;
  }
}

/// The time of a turn is the integral of d(angle) / rate, the rate from the energy; the trapezoidal rule over
/// a whole period converges faster than any power. Differences over 2e-3 rad err by 1e-10 of the rates.
TEST(SpatialSliderCrankReference, TurnsOnceInTheTimeThatItsEnergyGives) {
  const SpatialSliderCrankState at_start = spatial_slider_crank(0.0);
  const double start = energy(at_start.rod_angular_velocity, frame(0.0).col(0), at_start.crank_end,
                              at_start.crank_end_velocity, at_start.slider_velocity);
  constexpr int points = 600;
  double turn = 0.0;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    const Vector3d rest = Vector3d::Zero(), along = frame(angle).col(0), b = crank_end(angle);
    const Matrix3d W = test::slope(frame, angle, 1e-3) * frame(angle).transpose();
    const double potential = energy(rest, along, b, rest, rest);
    const double half_inertia = energy(vector_of(W), along, b, test::slope(crank_end, angle, 1e-3),
                                       test::slope(slider, angle, 1e-3)) -
                                potential;
    turn += 2 * std::numbers::pi / points * std::sqrt(half_inertia / (start - potential));
  }
  for (const int n : {1, 8}) {
    const SpatialSliderCrankState s = spatial_slider_crank(n * turn);
    EXPECT_NEAR(s.angle, 2 * std::numbers::pi * n, 1e-11) << n;
    EXPECT_NEAR(s.rate, 6.0, 1e-11) << n;
  }
}

/// The slider's place of a solution sent to the library (Gonzalez). It differs by up to 4.3e-5 m; other
/// solutions there differ from this one by 1e-2 m, as they place the crank's centre or the start elsewhere.
TEST(SpatialSliderCrankReference, AgreesWithAPublishedSolution) {
  EXPECT_NEAR(spatial_slider_crank(0.1).slider[0], 0.226785384, 2e-6);
  EXPECT_NEAR(spatial_slider_crank(0.5).slider[0], 0.184952803, 1e-6);
  EXPECT_NEAR(spatial_slider_crank(1.0).slider[0], 0.211754668, 4e-5);
  EXPECT_NEAR(spatial_slider_crank(5.0).slider[0], 0.240761815, 5e-5);
}

}  // namespace
}  // namespace tandem::mechanisms
