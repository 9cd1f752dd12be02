// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/andrews.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <vector>

#include "rod_energy.hpp"

namespace tandem::mechanisms {
namespace {

using Real = long double;
using Angles = Eigen::Matrix<Real, 7, 1>;
using Loops = Eigen::Matrix<Real, 6, 1>;
using LoopGradients = Eigen::Matrix<Real, 6, 7>;

constexpr AndrewsParameters p;
/// At the start, as published with the test set.
constexpr std::array<Real, 7> start{-0.0617138900142764496358948458001L, 0,
                                    0.455279819163070380255912382449L,   0.222668390165885884674473185609L,
                                    0.487364979543842550225598953530L,   -0.222668390165885884674473185609L,
                                    1.23054744454982119249735015568L};

/// One term of a loop: length times the unit vector at an angle that is a sum of two of the seven (-1: of
/// one).
struct Term {
  int loop;
  Real length;
  int first, second;
  bool from_below;  ///< the angle counts from -y
};
const std::array<Term, 10> terms{{{0, p.rr, 0, -1, false},
                                  {0, -p.d, 0, 1, false},
                                  {0, -p.ss, 2, -1, true},
                                  {1, p.rr, 0, -1, false},
                                  {1, -p.d, 0, 1, false},
                                  {1, -p.e, 3, 4, true},
                                  {1, -p.zt, 4, -1, false},
                                  {2, p.rr, 0, -1, false},
                                  {2, -p.d, 0, 1, false},
                                  {2, -p.zf, 5, 6, false}}};

/// The three loops O F E B, O F E G A, O F E H A of the literature, g(q) = 0, with their gradients and
/// g_qq v v.
struct Closure {
  Loops g = Loops::Zero(), curvature = Loops::Zero();
  LoopGradients gradient = LoopGradients::Zero();

  Closure(const Angles& q, const Angles& v) {
    for (const Term& term : terms) add(term, q, v);
    add({2, -p.u, 6, -1, true}, q, v);
    g -= (Loops() << p.xb, p.yb, p.xa, p.ya, p.xa, p.ya).finished();
  }
  void add(const Term& term, const Angles& q, const Angles& v) {
    const bool both = term.second >= 0;
    const Real angle = q[term.first] + (both ? q[term.second] : 0),
               rate = v[term.first] + (both ? v[term.second] : 0);
    Eigen::Matrix<Real, 2, 1> at(std::cos(angle), std::sin(angle));
    if (term.from_below) at = {std::sin(angle), -std::cos(angle)};
    at *= term.length;
    g.segment<2>(2 * term.loop) += at;
    curvature.segment<2>(2 * term.loop) -= rate * rate * at;
    for (const int angle_of : {term.first, term.second})
      if (angle_of >= 0)
        gradient.col(angle_of).segment<2>(2 * term.loop) += Eigen::Matrix<Real, 2, 1>(-at[1], at[0]);
  }
};

/// The mass matrix of the literature (E. Hairer, G. Wanner, sect. VII.7).
Eigen::Matrix<Real, 7, 7> mass_matrix(const Angles& q) {
  const auto& m = p.mass;
  const auto& I = p.inertia;
  const Real k4 = p.e - p.ea, k6 = p.zf - p.fa;
  Eigen::Matrix<Real, 7, 7> M = Eigen::Matrix<Real, 7, 7>::Zero();
  M(0, 0) = m[0] * p.ra * p.ra + I[0] + I[1] +
            m[1] * (p.rr * p.rr - 2 * p.da * p.rr * std::cos(q[1]) + p.da * p.da);
  M(0, 1) = M(1, 0) = m[1] * (p.da * p.da - p.da * p.rr * std::cos(q[1])) + I[1];
  M(1, 1) = m[1] * p.da * p.da + I[1];
  M(2, 2) = m[2] * (p.sa * p.sa + p.sb * p.sb) + I[2];
  M(3, 3) = m[3] * k4 * k4 + I[3];
  M(3, 4) = M(4, 3) = m[3] * (k4 * k4 + p.zt * k4 * std::sin(q[3])) + I[3];
  M(4, 4) = m[3] * (p.zt * p.zt + 2 * p.zt * k4 * std::sin(q[3]) + k4 * k4) + I[3] + I[4] +
            m[4] * (p.ta * p.ta + p.tb * p.tb);
  M(5, 5) = m[5] * k6 * k6 + I[5];
  M(5, 6) = M(6, 5) = m[5] * (k6 * k6 - p.u * k6 * std::sin(q[5])) + I[5];
  M(6, 6) = m[5] * (k6 * k6 - 2 * p.u * k6 * std::sin(q[5]) + p.u * p.u) + I[5] + I[6] +
            m[6] * (p.ua * p.ua + p.ub * p.ub);
  return M;
}

/// The forces of the literature.
Angles forces(const Angles& q, const Angles& v) {
  const auto& m = p.mass;
  const Real x = p.sd * std::cos(q[2]) + p.sc * std::sin(q[2]),
             y = p.sd * std::sin(q[2]) - p.sc * std::cos(q[2]);
  const Real dx = x + p.xb - p.xc, dy = y + p.yb - p.yc, length = std::hypot(dx, dy);
  const Real pull = -p.stiffness * (length - p.free_length) / length;
  const Real k4 = m[3] * p.zt * (p.e - p.ea) * std::cos(q[3]),
             k6 = m[5] * p.u * (p.zf - p.fa) * std::cos(q[5]);
  const Real k2 = m[1] * p.da * p.rr * std::sin(q[1]);
  return (Angles() << p.torque - k2 * v[1] * (v[1] + 2 * v[0]), k2 * v[0] * v[0], pull * (dy * x - dx * y),
          k4 * v[4] * v[4], -k4 * v[3] * (v[3] + 2 * v[4]), -k6 * v[6] * v[6], k6 * v[5] * (v[5] + 2 * v[6]))
      .finished();
}

using State = std::vector<Real>;

/// M v' + G^T lambda = f, G v' = -g_qq v v: the index-1 form of all seven angles.
void seven_angle_rates(const State& y, State& rate, Real) {
  const Angles q = Eigen::Map<const Angles>(y.data()), v = Eigen::Map<const Angles>(y.data() + 7);
  const Closure closure(q, v);
  Eigen::Matrix<Real, 13, 13> left = Eigen::Matrix<Real, 13, 13>::Zero();
  left.topLeftCorner<7, 7>() = mass_matrix(q);
  left.bottomLeftCorner<6, 7>() = closure.gradient;
  left.topRightCorner<7, 6>() = closure.gradient.transpose();
  Eigen::Matrix<Real, 13, 1> right;
  right << forces(q, v), -closure.curvature;
  const Eigen::Matrix<Real, 13, 1> solution = left.fullPivLu().solve(right);
  for (int i = 0; i < 7; ++i) {
    rate[i] = v[i];
    rate[7 + i] = solution[i];
  }
}

Angles extended(const std::array<double, 7>& values) {
  return Eigen::Map<const Eigen::Matrix<double, 7, 1>>(values.data()).cast<Real>();
}

TEST(AndrewsReference, BeginsWithThePublishedAnglesAndAccelerations) {
  const AndrewsState s = andrews(0.0);
  for (int i = 0; i < 7; ++i) EXPECT_NEAR(s.angles[i], static_cast<double>(start[i]), 1e-15) << i;
  EXPECT_NEAR(s.accelerations[0] / 14222.4439199541138705911625887, 1.0, 1e-14);
  EXPECT_NEAR(s.accelerations[1] / -10666.8329399655854029433719415, 1.0, 1e-14);
  for (int i = 2; i < 7; ++i) EXPECT_NEAR(s.accelerations[i], 0.0, 1e-11) << i;
}

TEST(AndrewsReference, ClosesItsLoopsInPlaceAndVelocity) {
  for (double t = 0.0; t < 0.031; t += 0.0031) {
    const AndrewsState s = andrews(t);
    const Angles v = extended(s.rates);
    const Closure closure(extended(s.angles), v);
    EXPECT_LT(closure.g.norm(), 1e-15L) << t;
    EXPECT_LT((closure.gradient * v).norm(), 1e-12L) << t;
    EXPECT_LT((closure.gradient * extended(s.accelerations) + closure.curvature).norm(), 1e-9L) << t;
  }
}

/// Energy less the torque's work, of about 0.5 J, by the literature's mass matrix.
TEST(AndrewsReference, KeepsItsEnergyButForTheWorkOfTheTorque) {
  const auto energy = [](const AndrewsState& s) {
    const Angles q = extended(s.angles), v = extended(s.rates);
    const Eigen::Vector2d spring =
        s.joints.D - Eigen::Vector2d(static_cast<double>(p.xc), static_cast<double>(p.yc));
    const Real stretch = spring.norm() - p.free_length;
    return static_cast<double>(v.dot(mass_matrix(q) * v) / 2 + p.stiffness * stretch * stretch / 2 -
                               p.torque * (q[0] - start[0]));
  };
  const double at_start = energy(andrews(0.0));
  for (double t = 0.0; t < 0.031; t += 0.0031) EXPECT_NEAR(energy(andrews(t)), at_start, 1e-12) << t;
}

/// All seven angles by multipliers and another method, of Gragg, Bulirsch and Stoer.
TEST(AndrewsReference, AgreesWithTheMotionInSevenAngles) {
  State y(start.begin(), start.end());
  y.resize(14, 0.0L);
  boost::numeric::odeint::bulirsch_stoer<State, Real> method(1e-17L, 1e-17L);
  boost::numeric::odeint::integrate_adaptive(method, seven_angle_rates, y, 0.0L, 0.03L, 1e-5L);
  const AndrewsState s = andrews(0.03);
  for (int i = 0; i < 7; ++i) {
    EXPECT_NEAR(s.angles[i], static_cast<double>(y[i]), 1e-12 * std::max(1.0, std::abs(s.angles[i]))) << i;
    EXPECT_NEAR(s.rates[i], static_cast<double>(y[7 + i]), 1e-12 * std::max(1e3, std::abs(s.rates[i]))) << i;
  }
}

/// The published state errs by about 1e-12 s, 1.2e-9 rad of beta, as its tolerances of 1e-14 let one expect; the
/// rates move by the accelerations times that, 6e-7 rad/s.
TEST(AndrewsReference, AgreesWithThePublishedStateToTenDigits) {
  const AndrewsState s = andrews(0.03);
  const AndrewsPublished published;
  for (int i = 0; i < 7; ++i) {
    EXPECT_NEAR(s.angles[i], published.angles[i], 2e-10 * std::max(1.0, std::abs(s.angles[i]))) << i;
    EXPECT_NEAR(s.rates[i], published.rates[i], 1e-6) << i;
  }
}

TEST(AndrewsReference, ItsJointsMoveWithTheVelocitiesGiven) {
  const auto G = [](double t) { return andrews(t).joints.G; };
  const auto D = [](double t) { return andrews(t).joints.D; };
  for (const double t : {0.004, 0.02}) {
    EXPECT_NEAR((test::slope(G, t, 1e-6) - andrews(t).velocities.G).norm(), 0.0, 1e-8) << t;
    EXPECT_NEAR((test::slope(D, t, 1e-6) - andrews(t).velocities.D).norm(), 0.0, 1e-8) << t;
  }
}

}  // namespace
}  // namespace tandem::mechanisms
