// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/double_pendulum.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <boost/numeric/odeint.hpp>
#include <vector>

#include "refusal.hpp"
#include "rod_energy.hpp"

namespace tandem::mechanisms {
namespace {

using Real = long double;
using PendulumFour = std::vector<Real>;  // elbow, tip, their velocities
using PendulumVector = Eigen::Matrix<Real, 2, 1>;
using Matrix = Eigen::Matrix<Real, 6, 6>;

/// Both rods by the Cartesian coordinates of elbow and tip, with multipliers for their lengths: the mass
/// matrix of a rod by its ends is m/6 [2 1; 1 2], and each end carries half the weight.
void cartesian_rates(const PendulumFour& y, PendulumFour& rate, Real) {
  const PendulumVector elbow(y[0], y[1]), rod(y[2] - y[0], y[3] - y[1]), v(y[4], y[5]),
      turn(y[6] - y[4], y[7] - y[5]);
  Matrix left = Matrix::Zero();
  for (int i = 0; i < 2; ++i) {
    left(i, i) = 2.0L / 3;
    left(2 + i, 2 + i) = 1.0L / 3;
    left(i, 2 + i) = left(2 + i, i) = 1.0L / 6;
    left(i, 4) = left(4, i) = elbow[i];
    left(i, 5) = left(5, i) = -rod[i];
    left(2 + i, 5) = left(5, 2 + i) = rod[i];
  }
  Eigen::Matrix<Real, 6, 1> right;
  right << 0, -9.81L, 0, -9.81L / 2, -v.dot(v), -turn.dot(turn);
  const Eigen::Matrix<Real, 6, 1> solution = left.fullPivLu().solve(right);
  for (int i = 0; i < 4; ++i) {
    rate[i] = y[4 + i];
    rate[4 + i] = solution[i];
  }
}

TEST(DoublePendulumReference, KeepsItsLengthsAndEnergy) {
  for (double t = 0.0; t < 10.0; t += 0.61) {
    const DoublePendulumState s = double_pendulum(t);
    EXPECT_NEAR(s.elbow.norm(), 1.0, 1e-14);
    EXPECT_NEAR((s.tip - s.elbow).norm(), 1.0, 1e-14);
    const test::Moving elbow{s.elbow, s.elbow_velocity};
    const double energy = test::rod_energy(1.0, test::resting(2), elbow, 1) +
                          test::rod_energy(1.0, elbow, {s.tip, s.tip_velocity}, 1);
    EXPECT_NEAR(energy, 0.0, 1e-12) << t;
  }
}

/// Other coordinates and another method: of Gragg, Bulirsch and Stoer. Its steps err by 1e-18, some hundreds
/// of them, the lengths drift, and the motion makes that 2e3 times larger in ten seconds.
TEST(DoublePendulumReference, AgreesWithTheMotionInCartesianCoordinates) {
  PendulumFour y{1, 0, 2, 0, 0, 0, 0, 0};
  Real reached = 0;
  for (const double t : {1.0, 3.0, 10.0}) {
    boost::numeric::odeint::bulirsch_stoer<PendulumFour, Real> method(1e-18L, 1e-18L);
    boost::numeric::odeint::integrate_adaptive(method, cartesian_rates, y, reached, Real{t}, Real{1e-3L});
    reached = t;
    const DoublePendulumState s = double_pendulum(t);
    EXPECT_NEAR(s.elbow[0], static_cast<double>(y[0]), 1e-11) << t;
    EXPECT_NEAR(s.elbow[1], static_cast<double>(y[1]), 1e-11) << t;
    EXPECT_NEAR(s.tip[0], static_cast<double>(y[2]), 1e-11) << t;
    EXPECT_NEAR(s.tip[1], static_cast<double>(y[3]), 1e-11) << t;
    EXPECT_NEAR(s.tip_velocity[0], static_cast<double>(y[6]), 1e-10) << t;
    EXPECT_NEAR(s.tip_velocity[1], static_cast<double>(y[7]), 1e-10) << t;
  }
}

/// The same equations in the angles in 113 bits, ten thousand equal steps of order 8; five thousand differ by
/// 2.8e-12, so these err by 1e-14.
TEST(DoublePendulumReference, HasTwelveDigitsAfterTenSeconds) {
  const Eigen::Vector2d tip = double_pendulum(10.0).tip;
  EXPECT_NEAR(tip[0], -1.655867424180034, 1e-12);
  EXPECT_NEAR(tip[1], -0.5284454810249632, 1e-12);
}

/// Newton's law of the second rod's centre, and the moment about the origin of what turns the first; by
/// differences over 1e-4 s, which rounding disturbs by 1e-11.
TEST(DoublePendulumReference, ItsElbowForceMovesTheSecondRodAndTurnsTheFirst) {
  for (const double t : {0.1, 0.7, 2.9}) {
    const auto momentum = [](double at) {
      const DoublePendulumState s = double_pendulum(at);
      const double turn = (s.elbow[0] * s.elbow_velocity[1] - s.elbow[1] * s.elbow_velocity[0]) / 3;
      const Eigen::Vector2d centre = (s.elbow_velocity + s.tip_velocity) / 2;
      return Eigen::Vector3d(centre[0], centre[1], turn);
    };
    const DoublePendulumState s = double_pendulum(t);
    const Eigen::Vector3d change = test::slope(momentum, t, 1e-4);
    EXPECT_NEAR(change[0], s.elbow_force[0], 1e-8) << t;
    EXPECT_NEAR(change[1], s.elbow_force[1] - 9.81, 1e-8) << t;
    const double moment = -(s.elbow[0] * s.elbow_force[1] - s.elbow[1] * s.elbow_force[0]);
    EXPECT_NEAR(change[2], moment - 9.81 * s.elbow[0] / 2, 1e-8) << t;
  }
}

TEST(DoublePendulumReference, RefusesATimeBeforeTheStart) {
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"time of a reference is -1 s; allowed is from 0 s"},
                            [] { double_pendulum(-1.0); }));
}

}  // namespace
}  // namespace tandem::mechanisms
