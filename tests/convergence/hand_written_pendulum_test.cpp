// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The example of docs/models_in_cpp.md, alone and as a subsystem.
#include <gtest/gtest.h>

#include <cmath>

#include "pendulum_subsystem.hpp"
#include "tandem/coordinator/coordinator.hpp"

namespace example {
namespace {

/// On the circle the spring is a constant force to (0, -1), so this is a pendulum in the field G below: let
/// go at the angle a from it, it hangs along G after a quarter of its period, K(sin(a/2))/sqrt(|G|).
struct Quarter {
  explicit Quarter(double push) {
    const Eigen::Vector2d field(push / Pendulum::mass,
                                -Pendulum::gravity - Pendulum::spring / Pendulum::mass);
    place = field.normalized();
    time = std::comp_ellint_1(std::sin(0.5 * std::acos(place[0]))) / std::sqrt(field.norm());
  }
  Eigen::Vector2d place;
  double time;
};

double alone(int steps) {
  const Quarter exact(0.0);
  Pendulum pendulum;
  const auto stepper = tandem::mbs::make_stepper(pendulum, {});
  tandem::mbs::State s = Pendulum::level(0.0);
  stepper->start(s);
  for (int k = 1; k <= steps; ++k) stepper->step(s, exact.time / steps, exact.time / steps * k);
  return (s.q - exact.place).norm();
}

/// Pushed with 6 N.
double coupled(int steps) {
  const Quarter exact(6.0);
  PendulumSubsystem pendulum(exact.time / steps);
  tandem::Topology topology;
  topology.add("pendulum", pendulum.info());
  topology.set_start("pendulum.push", 6.0);
  topology.check();
  tandem::Coordinator(topology, {&pendulum}, {}, {0.0, exact.time}).run();
  return (pendulum.state().q - exact.place).norm();
}

TEST(HandWrittenPendulum, HangsAfterAQuarterOfItsPeriodWithOrderTwo) {
  for (const auto& error : {alone, coupled}) {
    const double coarse = error(250), fine = error(500);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2) << coarse << " " << fine;
    EXPECT_LT(coarse, 1e-4) << "the method changes the force by 3/4 (h theta')^2 of itself, below 1e-4";
  }
}

}  // namespace
}  // namespace example
