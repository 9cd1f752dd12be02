// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/rotor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <vector>

#include "rod_energy.hpp"

namespace tandem::mechanisms {
namespace {

using Real = long double;
using RotorSix = std::vector<Real>;  // quaternion w, x, y, z; angular velocity along the principal axes
using RotorVector = Eigen::Matrix<Real, 3, 1>;

/// Euler's equations with the quaternion's, q' = q (0, omega) / 2, by the method of Gragg, Bulirsch and
/// Stoer.
RotorState integrated(const RotorVector& inertia, Real tilt, double t) {
  const Eigen::Quaternion<Real> start(Eigen::AngleAxis<Real>(tilt, RotorVector::UnitY()));
  RotorSix y{
      start.w(), 0, start.y(), 0, -2 * std::sin(tilt) / inertia[0], 0, 2 * std::cos(tilt) / inertia[2]};
  const auto rates = [&](const RotorSix& s, RotorSix& rate, Real) {
    const RotorVector omega(s[4], s[5], s[6]);
    const RotorVector moment = RotorVector(inertia.cwiseProduct(omega)).cross(omega);
    const Eigen::Quaternion<Real> turned = Eigen::Quaternion<Real>(s[0], s[1], s[2], s[3]) *
                                           Eigen::Quaternion<Real>(0, s[4] / 2, s[5] / 2, s[6] / 2);
    rate = {turned.w(),
            turned.x(),
            turned.y(),
            turned.z(),
            moment[0] / inertia[0],
            moment[1] / inertia[1],
            moment[2] / inertia[2]};
  };
  boost::numeric::odeint::bulirsch_stoer<RotorSix, Real> method(1e-17L, 1e-17L);
  boost::numeric::odeint::integrate_adaptive(method, rates, y, Real{0}, Real{t}, Real{1e-3L});
  const auto axes = Eigen::Quaternion<Real>(y[0], y[1], y[2], y[3]).toRotationMatrix();
  return {axes.cast<double>(), (axes * RotorVector(y[4], y[5], y[6])).cast<double>()};
}

void expect_near(const RotorState& a, const RotorState& b, double tolerance) {
  EXPECT_NEAR((a.axes - b.axes).norm(), 0.0, tolerance);
  EXPECT_NEAR((a.angular_velocity - b.angular_velocity).norm(), 0.0, 10 * tolerance);
}

TEST(RotorReference, FollowsEulersEquations) {
  for (const double t : {0.0, 0.03125, 0.1, 1.0, 10.0}) {
    SCOPED_TRACE(t);
    expect_near(rotor(t), integrated({0.3L, 0.3L, 0.5L}, 0.4L, t), 1e-13);
    expect_near(asymmetric_rotor(t), integrated({0.3L, 0.4L, 0.5L}, 0.6L, t), 1e-13);
  }
}

TEST(RotorReference, BeginsAsDescribed) {
  for (const auto& [s, tilt] : {std::pair{rotor(0.0), 0.4}, {asymmetric_rotor(0.0), 0.6}}) {
    EXPECT_NEAR((s.axes.col(0) - Eigen::Vector3d(std::cos(tilt), 0, -std::sin(tilt))).norm(), 0.0, 1e-15);
    EXPECT_NEAR((s.axes.col(1) - Eigen::Vector3d(0, 1, 0)).norm(), 0.0, 1e-15);
    EXPECT_NEAR((s.axes.col(2) - Eigen::Vector3d(std::sin(tilt), 0, std::cos(tilt))).norm(), 0.0, 1e-15);
  }
}

/// The kinetic energy is half of the sum of the squared components of the moment of momentum over the
/// inertias.
TEST(RotorReference, KeepsEnergyAndMomentOfMomentum) {
  const Eigen::DiagonalMatrix<double, 3> inertia(0.3, 0.4, 0.5);
  for (double t = 0.0; t < 10.0; t += 0.31) {
    const RotorState s = asymmetric_rotor(t);
    const Eigen::Vector3d momentum = s.axes * (inertia * (s.axes.transpose() * s.angular_velocity));
    EXPECT_NEAR((momentum - Eigen::Vector3d(0, 0, 2)).norm(), 0.0, 1e-14) << t;
    const double energy = 2 * (std::pow(std::sin(0.6), 2) / 0.3 + std::pow(std::cos(0.6), 2) / 0.5);
    EXPECT_NEAR(s.angular_velocity.dot(momentum) / 2, energy, 1e-14) << t;
  }
}

/// Fifth derivatives of the axes are below 1e5, so e = 1e-3 errs by 1e-8 / 3 at most.
TEST(RotorReference, ItsAxesTurnWithTheAngularVelocity) {
  for (const double t : {0.2, 3.3}) {
    const auto axis = [](double at) { return asymmetric_rotor(at).axes.col(0).eval(); };
    const RotorState s = asymmetric_rotor(t);
    const Eigen::Vector3d expected = s.angular_velocity.cross(s.axes.col(0));
    EXPECT_NEAR((test::slope(axis, t, 1e-3) - expected).norm(), 0.0, 1e-8) << t;
  }
}

}  // namespace
}  // namespace tandem::mechanisms
