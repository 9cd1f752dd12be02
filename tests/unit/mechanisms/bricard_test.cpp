// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/bricard.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "rod_energy.hpp"

namespace tandem::mechanisms {
namespace {

using Eigen::Vector3d;
constexpr double right_angle = std::numbers::pi / 2;

/// The points by joint angles: rod after rod is turned about the joint's axis, theta at P0, P2, P4, phi at
/// P1, P3; the axis at its end is a right angle on, to the right and to the left in turn.
std::array<Vector3d, 6> chain(double theta, double phi) {
  std::array<Vector3d, 6> points;
  points[0].setZero();
  Vector3d rod(0, 0, -1), axis(0, 1, 0);
  for (int i = 0; i < 5; ++i) {
    rod = Eigen::AngleAxisd(i % 2 == 0 ? theta : phi, axis) * rod;
    points[i + 1] = points[i] + rod;
    axis = (i % 2 == 0 ? 1.0 : -1.0) * rod.cross(axis);
  }
  return points;
}

/// The angle at P1, P3, P5 that closes the ring: cos theta + cos phi + cos theta cos phi = 0
/// (Y. Chen, Z. You, T. Tarnai, Int. J. Solids Struct. 42, 2005, for axes at right angles).
double other_angle(double theta) { return -std::acos(-std::cos(theta) / (1 + std::cos(theta))); }

double potential(const std::array<Vector3d, 6>& points) {
  double sum = 0.0;
  for (int i = 0; i < 5; ++i) sum += 9.81 * (points[i][1] + points[i + 1][1]) / 2;
  return sum;
}

TEST(BricardReference, BeginsAlongTheEdgesOfACubeAtRest) {
  const std::array<Vector3d, 6> cube{Vector3d(0, 0, 0),  Vector3d(1, 0, 0),  Vector3d(1, -1, 0),
                                     Vector3d(1, -1, 1), Vector3d(0, -1, 1), Vector3d(0, 0, 1)};
  const BricardState s = bricard(0.0);
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR((s.points[i] - cube[i]).norm(), 0.0, 1e-15) << i;
    EXPECT_NEAR((s.axes[i] - Vector3d::Unit((i + 1) % 3)).norm(), 0.0, 1e-15) << i;
    EXPECT_EQ(s.velocities[i].norm(), 0.0) << i;
  }
}

TEST(BricardReference, KeepsRodsJointsAndEnergy) {
  for (double t = 0.0; t < 10.0; t += 0.37) {
    const BricardState s = bricard(t);
    EXPECT_NEAR((s.points[5] - Vector3d(0, 0, 1)).norm(), 0.0, 1e-15) << t;
    EXPECT_NEAR((s.axes[5] - Vector3d(1, 0, 0)).norm(), 0.0, 1e-15) << t;
    double energy = 0.0;
    for (int i = 0; i < 5; ++i) {
      const Vector3d rod = s.points[i + 1] - s.points[i];
      EXPECT_NEAR(rod.norm(), 1.0, 1e-15) << t;
      EXPECT_NEAR(rod.dot(s.axes[i]), 0.0, 1e-15) << t;
      EXPECT_NEAR(rod.dot(s.axes[i + 1]), 0.0, 1e-15) << t;
      EXPECT_NEAR(s.axes[i].dot(s.axes[i + 1]), 0.0, 1e-15) << t;
      energy +=
          test::rod_energy(1.0, {s.points[i], s.velocities[i]}, {s.points[i + 1], s.velocities[i + 1]}, 1);
    }
    EXPECT_NEAR(energy, -3 * 9.81, 1e-12) << t;
  }
}

TEST(BricardReference, IsAChainOfRodsTurnedByTwoAnglesThatCloseTheRing) {
  for (double t = 0.0; t < 10.0; t += 0.37) {
    const BricardState s = bricard(t);
    const double theta = std::atan2(-s.points[1][0], -s.points[1][2]);
    const auto expected = chain(theta, other_angle(theta));
    for (int i = 0; i < 6; ++i) EXPECT_NEAR((s.points[i] - expected[i]).norm(), 0.0, 1e-13) << t << " " << i;
  }
}

/// Quintic terms of the motion are below 1e3 m/s^5, so e = 1e-3 errs by 1e-10 / 3 at most.
TEST(BricardReference, ItsVelocitiesAreTheRatesOfItsPlaces) {
  for (const double t : {0.3, 1.2, 6.1})
    for (int i = 1; i < 5; ++i) {
      const auto place = [&](double at) { return bricard(at).points[i]; };
      EXPECT_NEAR((test::slope(place, t, 1e-3) - bricard(t).velocities[i]).norm(), 0.0, 1e-10)
          << t << " " << i;
    }
}

/// theta goes from -90 to 90 degrees and back. A period is 2 integral of sqrt(J / (2 (V0 - V))) d(theta), J
/// from differences of the chain; with theta = 90 degrees sin w the ends are smooth and the rule of equal
/// weights converges faster than any power.
TEST(BricardReference, SwingsInTheTimeThatItsEnergyGives) {
  constexpr int points = 200;
  double period = 0.0;
  for (int k = 0; k < points; ++k) {
    const double w = std::numbers::pi * ((k + 0.5) / points - 0.5), theta = right_angle * std::sin(w);
    const auto place = [](double at) {
      const auto p = chain(at, other_angle(at));
      Eigen::Matrix<double, 3, 6> matrix;
      for (int i = 0; i < 6; ++i) matrix.col(i) = p[i];
      return matrix;
    };
    const Eigen::Matrix<double, 3, 6> v = test::slope(place, theta, 5e-4 * std::cos(w));
    double inertia = 0.0;
    for (int i = 0; i < 5; ++i)
      inertia += (v.col(i).dot(v.col(i)) + v.col(i).dot(v.col(i + 1)) + v.col(i + 1).dot(v.col(i + 1))) / 3;
    const double fallen = -3 * 9.81 - potential(chain(theta, other_angle(theta)));
    period += 2 * std::numbers::pi / points * std::sqrt(inertia / (2 * fallen)) * right_angle * std::cos(w);
  }
  EXPECT_NEAR(period, 4.98630860865727, 1e-12);
  EXPECT_NEAR((bricard(period / 4).points[3] - Vector3d(0, -std::sqrt(3.0), 0)).norm(), 0.0, 1e-11);
  EXPECT_NEAR((bricard(period / 2).points[3] - Vector3d(-1, -1, 1)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((bricard(1.75 * period).points[3] - Vector3d(0, -std::sqrt(3.0), 0)).norm(), 0.0, 1e-11);
}

}  // namespace
}  // namespace tandem::mechanisms
