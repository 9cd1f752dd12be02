// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The index-3 formulation on mechanisms of which the motion is known.
#include "tandem/mbs/formulations/index3.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "driven_pendulum.hpp"
#include "four_bar/linkage.hpp"
#include "refusal.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

double order(double coarse, double fine) { return std::log2(coarse / fine); }

State run(Mechanism& mechanism, const Index3Settings& settings, double h, double end) {
  Index3 formulation(mechanism, settings);
  State s = mechanism.described_state();
  formulation.start(s);
  const long steps = std::lround(end / h);
  for (long k = 1; k <= steps; ++k) formulation.step(s, h, static_cast<double>(k) * h);
  return s;
}

/// The linkage where all its cranks have that angle and rate.
State standing(Mechanism& linkage, const four_bar::Crank& crank) {
  State s = linkage.described_state();
  const int points = linkage.structure().variables / 2;
  for (int i = 0; i < points; ++i) {
    s.q.segment(2 * i, 2) << i + std::sin(crank.angle), std::cos(crank.angle);
    s.v.segment(2 * i, 2) << std::cos(crank.angle) * crank.rate, -std::sin(crank.angle) * crank.rate;
  }
  Index3(linkage, {}).start(s);
  return s;
}

/// The linkage before its flat position against its exact motion and the multipliers that belong to it.
TEST(Index3, IsOfOrderTwoInPositionsVelocitiesAccelerationsAndMultipliers) {
  constexpr double end = 0.5;
  Mechanism linkage(read_mechanism("linkage", four_bar::text(2)));
  const State exact = standing(linkage, four_bar::exact(2, end));
  const auto errors = [&](int steps) {
    Index3 formulation(linkage, {.penalty = 1e8, .tolerance = 1e-12, .projections = 3});
    State s = linkage.described_state();
    formulation.start(s);
    for (int k = 1; k <= steps; ++k) formulation.step(s, end / steps, k * end / steps);
    return std::array{(s.q - exact.q).norm(), (s.v - exact.v).norm(), (s.a - exact.a).norm(),
                      (s.lambda - exact.lambda).norm()};
  };
  const auto coarse = errors(128), fine = errors(256);
  for (std::size_t k = 0; k < coarse.size(); ++k) EXPECT_NEAR(order(coarse[k], fine[k]), 2.0, 0.2) << k;
}

TEST(Index3, ReachesTheEndOfTheLinkageThroughItsFlatPositions) {
  for (const int loops : {1, 2, 5, 20})
    for (const char* solver : {"klu", "band"}) {
      Mechanism linkage(read_mechanism("linkage", four_bar::text(loops)));
      const State s = run(linkage, {.penalty = 1e8, .solver = solver}, 1.25e-3, 20.0);
      EXPECT_NEAR(s.q[0], std::sin(four_bar::exact(loops, 20.0).angle), 2e-3) << loops << " " << solver;
      for (int i = 1; i <= loops; ++i) {  // still a parallelogram
        EXPECT_NEAR(s.q[2 * i] - s.q[0], i, 1e-5);
        EXPECT_NEAR(s.q[2 * i + 1] - s.q[1], 0.0, 1e-5);
      }
    }
}

TEST(Index3, KeepsConstraintsOfPositionVelocityAndAcceleration) {
  Mechanism linkage(read_mechanism("linkage", four_bar::text(3)));
  const State s = run(linkage, {}, 1e-3, 0.4);
  const Structure& structure = linkage.structure();
  Eigen::VectorXd phi(structure.constraints), jacobian(structure.jacobian_values), rate(phi), gamma(phi);
  linkage.constraints(s.q.data(), phi.data(), jacobian.data());
  EXPECT_LT(phi.lpNorm<Eigen::Infinity>(), 1e-10);
  multiply_transposed(structure.jacobian, jacobian.data(), s.v.data(), rate.data());
  EXPECT_LT(rate.lpNorm<Eigen::Infinity>(), 1e-5);
  multiply_transposed(structure.jacobian, jacobian.data(), s.a.data(), rate.data());
  linkage.constraint_accelerations(s.q.data(), s.v.data(), gamma.data());
  EXPECT_LT((rate + gamma).lpNorm<Eigen::Infinity>(), 1e-2);
}

/// A body of revolution without forces: its axis goes round the constant angular momentum at the rate
/// |L| / I1 (L. Landau, E. Lifshitz, Mechanics, sect. 33).
TEST(Index3, FollowsTheFreePrecessionOfARotorInSpace) {
  constexpr double i1 = 0.3, i3 = 0.5, tilt = 0.4, momentum = 2.0, end = 1.0;
  Description in;
  in.name = "rotor";
  const Eigen::Vector3d axis(std::sin(tilt), 0, std::cos(tilt)), side(std::cos(tilt), 0, -std::sin(tilt)),
      across(0, 1, 0), l(0, 0, momentum);
  const Eigen::Vector3d w = l.dot(axis) / i3 * axis + l.dot(side) / i1 * side;
  in.entities.push_back({"O", Entity::Kind::point, false, Eigen::Vector3d::Zero()});
  for (const auto& [name, v] : {std::pair{"e", axis}, {"m", side}, {"n", across}})
    in.entities.push_back({name, Entity::Kind::vector, false, v, w.cross(v)});
  Body body{"rotor", {0, 1, 2, 3}, 1.0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};
  body.inertia = i3 * axis * axis.transpose() + i1 * (side * side.transpose() + across * across.transpose());
  in.bodies.push_back(body);
  Mechanism rotor(in);
  ASSERT_EQ(rotor.structure().constraints, 6);
  const double turn = momentum / i1 * end;
  const Eigen::Vector3d expected(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn),
                                 std::cos(tilt));
  const auto error = [&](int steps) {
    const State s = run(rotor, {}, end / steps, end);
    return (s.q.segment(rotor.coordinate(1), 3) - expected).norm();
  };
  const double coarse = error(500), fine = error(1000);
  EXPECT_NEAR(order(coarse, fine), 2.0, 0.2);
  EXPECT_LT(fine, 1e-4);
}

/// Steps from where the multipliers settle with the last tangent (10 ms) to where they don't (0.1 ms). The
/// accelerations have settled to 1e-12 of themselves, and multipliers are known to alpha times their
/// rounding.
TEST(Index3, RefreshGivesTheAccelerationsOfANewInput) {
  for (const double h : {1e-2, 1e-3, 1e-4}) {
    test::DrivenPendulum pendulum({});
    Index3 formulation(pendulum, {});
    State s = pendulum.at(0.0, 1.0, 0.5);
    formulation.start(s);
    for (int k = 1; k <= 20; ++k) formulation.step(s, h, k * h);
    pendulum.input = 7.0;
    State expected = s;
    formulation.refresh(s);
    Index3(pendulum, {}).start(expected);
    EXPECT_LT((s.a - expected.a).norm(), 1e-11 * s.a.norm());
    EXPECT_LT((s.lambda - expected.lambda).norm(), 1e-6);
  }
}

TEST(Index3, SaysWhenItDoesNotConverge) {
  Mechanism linkage(read_mechanism("linkage", four_bar::text(2)));
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, {"no convergence at t = 0.2 s in 3 iterations"},
                            [&] { run(linkage, {.tolerance = 1e-14, .most_iterations = 3}, 0.2, 1.0); }));
}

TEST(Index3, RefusesSettingsThatAreNotAllowed) {
  Mechanism linkage(read_mechanism("linkage", four_bar::text(1)));
  const auto refused = [&](const Index3Settings& s, const std::vector<std::string>& says) {
    return test::refuses(ErrorCode::invalid_argument, says, [&] { Index3(linkage, s); });
  };
  EXPECT_TRUE(refused({.penalty = -1.0}, {"penalty is -1"}));
  EXPECT_TRUE(refused({.beta = 0.3}, {"beta is 0.3", "1/12 to 1/4"}));
  EXPECT_TRUE(refused({.tolerance = 0.0}, {"tolerance is 0"}));
  EXPECT_TRUE(refused({.most_iterations = 0}, {"most_iterations is 0"}));
  EXPECT_TRUE(refused({.solver = "kul"}, {"'kul'", "'klu'"}));
}

}  // namespace
}  // namespace tandem::mbs
