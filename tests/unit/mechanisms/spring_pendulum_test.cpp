// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/spring_pendulum.hpp"

#include <gtest/gtest.h>

#include <boost/numeric/odeint.hpp>
#include <vector>

namespace tandem::mechanisms {
namespace {

TEST(SpringPendulumReference, KeepsItsEnergy) {
  for (double t = 0.0; t < 10.0; t += 0.31) {
    const SpringPendulumState s = spring_pendulum(t);
    const double stretch = s.position.norm() - 1.0;
    EXPECT_NEAR(0.5 * s.velocity.squaredNorm() + 9.81 * s.position[1] + 50.0 * stretch * stretch, 2.0, 1e-12)
        << t;
  }
}

/// Newton's law in Cartesian coordinates by the method of Gragg, Bulirsch and Stoer.
TEST(SpringPendulumReference, AgreesWithTheMotionInCartesianCoordinates) {
  using State = std::vector<long double>;
  const auto rates = [](const State& y, State& rate, long double) {
    const long double length = std::hypot(y[0], y[1]), pull = 100.0L * (1.0L / length - 1.0L);
    rate[0] = y[2], rate[1] = y[3], rate[2] = pull * y[0], rate[3] = pull * y[1] - 9.81L;
  };
  for (const double t : {0.5, 3.0, 10.0}) {
    State y{1.2L, 0, 0, 0};
    boost::numeric::odeint::bulirsch_stoer<State, long double> method(1e-16L, 1e-16L);
    boost::numeric::odeint::integrate_adaptive(method, rates, y, 0.0L, static_cast<long double>(t), 1e-3L);
    const SpringPendulumState s = spring_pendulum(t);
    EXPECT_NEAR(s.position[0], static_cast<double>(y[0]), 1e-13) << t;
    EXPECT_NEAR(s.position[1], static_cast<double>(y[1]), 1e-13) << t;
    EXPECT_NEAR(s.velocity[0], static_cast<double>(y[2]), 1e-12) << t;
    EXPECT_NEAR(s.velocity[1], static_cast<double>(y[3]), 1e-12) << t;
  }
}

}  // namespace
}  // namespace tandem::mechanisms
