// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/pendulum.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <numbers>

#include "rod_energy.hpp"

namespace tandem::mechanisms {
namespace {

using test::Moving;

const double quarter_period = boost::math::ellint_1(std::sqrt(0.5)) / std::sqrt(1.5 * 9.81);

TEST(PendulumReference, StandsAtTheQuartersOfItsPeriodWhereItMust) {
  const PendulumState start = pendulum(0.0), bottom = pendulum(quarter_period),
                      far = pendulum(2 * quarter_period), back = pendulum(12 * quarter_period);
  EXPECT_NEAR((start.tip - Eigen::Vector2d(1, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((start.reaction - Eigen::Vector2d(0, 9.81 / 4)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((bottom.tip - Eigen::Vector2d(0, -1)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((bottom.velocity - Eigen::Vector2d(-std::sqrt(3 * 9.81), 0)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((bottom.reaction - Eigen::Vector2d(0, 2.5 * 9.81)).norm(), 0.0, 1e-13);
  EXPECT_NEAR((far.tip - Eigen::Vector2d(-1, 0)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((back.tip - Eigen::Vector2d(1, 0)).norm(), 0.0, 1e-13);
}

TEST(PendulumReference, KeepsItsLengthAndEnergy) {
  for (double t = 0.0; t < 10.0; t += 0.0937) {
    const PendulumState s = pendulum(t);
    EXPECT_NEAR(s.tip.norm(), 1.0, 1e-14);
    EXPECT_NEAR(test::rod_energy(1.0, test::resting(2), {s.tip, s.velocity}, 1), 0.0, 1e-13) << t;
  }
}

/// phi'' = -3/2 g sin phi integrated to 1e-13 a step, some two hundred steps.
TEST(PendulumReference, AgreesWithTheIntegratedEquationOfMotion) {
  using Angle = std::array<double, 2>;
  namespace ode = boost::numeric::odeint;
  for (const double t : {0.3, 2.0, 10.0}) {
    Angle y{std::numbers::pi / 2, 0.0};
    const auto rates = [](const Angle& s, Angle& rate, double) {
      rate = {s[1], -1.5 * 9.81 * std::sin(s[0])};
    };
    ode::integrate_adaptive(ode::make_controlled<ode::runge_kutta_dopri5<Angle>>(1e-14, 1e-14), rates, y, 0.0,
                            t, 1e-4);
    const PendulumState s = pendulum(t);
    EXPECT_NEAR((s.tip - Eigen::Vector2d(std::sin(y[0]), -std::cos(y[0]))).norm(), 0.0, 1e-11) << t;
  }
}

/// Newton's law of the centre; the fifth derivative of its velocity is below 1e6, so e = 1e-3 errs by 1e-7/3.
TEST(PendulumReference, ItsReactionIsWhatMovesTheCentre) {
  for (const double t : {0.01, 0.4, 1.7, 9.3}) {
    const auto momentum = [](double at) { return (0.5 * pendulum(at).velocity).eval(); };
    const Eigen::Vector2d force = test::slope(momentum, t, 1e-3) + Eigen::Vector2d(0, 9.81);
    EXPECT_NEAR((force - pendulum(t).reaction).norm(), 0.0, 1e-7) << t;
  }
}

}  // namespace
}  // namespace tandem::mechanisms
