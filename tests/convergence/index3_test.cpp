// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The index-3 formulation on mechanisms of which the motion is known.
#include "tandem/mbs/formulations/index3.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <random>

#include "driven_pendulum.hpp"
#include "four_bar/linkage.hpp"
#include "memory_of.hpp"
#include "refusal.hpp"
#include "standing_linkage.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/residuals.hpp"

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

/// The linkage before its flat position against its exact motion and the multipliers that belong to it.
TEST(Index3, IsOfOrderTwoInPositionsVelocitiesAccelerationsAndMultipliers) {
  constexpr double end = 0.5;
  Mechanism linkage(read_mechanism("linkage", four_bar::text(2)));
  const State exact = test::standing(linkage, four_bar::exact(2, end));
  const auto errors = [&](int steps) {
    Index3 formulation(linkage, {.penalty = 1e8, .tolerance = 1e-12});
    State s = linkage.described_state();
    formulation.start(s);
    for (int k = 1; k <= steps; ++k) formulation.step(s, end / steps, k * end / steps);
    return std::array{(s.q - exact.q).norm(), (s.v - exact.v).norm(), (s.a - exact.a).norm(),
                      (s.lambda - exact.lambda).norm()};
  };
  const auto coarse = errors(128), fine = errors(256);
  for (std::size_t k = 0; k < coarse.size(); ++k) EXPECT_NEAR(order(coarse[k], fine[k]), 2.0, 0.2) << k;
}

/// All own steps cut anywhere, as at events. Without own_step errors are up to 1000 times those of whole
/// steps.
TEST(Index3, IsAsGoodWithStepsThatAreCut) {
  constexpr double h = 1.25e-3, end = 0.5;
  for (const int loops : {1, 5}) {
    Mechanism linkage(read_mechanism("linkage", four_bar::text(loops)));
    const State exact = test::standing(linkage, four_bar::exact(loops, end));
    const auto error = [&](double shortest) {
      std::mt19937 random(3);
      std::uniform_real_distribution<double> exponent(std::log10(shortest), 0.0);
      Index3 formulation(linkage, {.penalty = 1e8, .own_step = h});
      State s = linkage.described_state();
      formulation.start(s);
      for (int k = 0; k < std::lround(end / h); ++k) {
        const double part = shortest < 1.0 ? h * std::pow(10.0, exponent(random)) : 0.0;
        if (part > 0.0) formulation.step(s, part, k * h + part);
        formulation.step(s, h - part, (k + 1) * h);
      }
      return std::max((s.q - exact.q).norm(), 0.1 * (s.v - exact.v).norm());
    };
    for (const double shortest : {0.1, 1e-3, 1e-9}) EXPECT_LT(error(shortest), 3.5 * error(1.0)) << shortest;
  }
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

/// x of the first moving point [m] as an independent program of the formulation has it, with the same
/// settings. Its errors are 3.8, 2.5, 1.7 and 1.2 mm; at most 1.05 of them are allowed, and no more than one
/// iteration a step.
TEST(Index3, ComesAsNearToTheLinkagesMotionAsAnIndependentProgram) {
  constexpr double end = 20.0, h = 1.25e-3;
  for (const auto& [loops, theirs] :
       {std::pair{5, 0.566072}, {10, 0.475292}, {20, 0.431272}, {40, 0.409735}}) {
    Mechanism linkage(read_mechanism("linkage", four_bar::text(loops)));
    Index3 formulation(linkage, {.penalty = 1e8, .tolerance = 1e-5});
    State s = linkage.described_state();
    formulation.start(s);
    const long steps = std::lround(end / h);
    long iterations = 0;
    for (long k = 1; k <= steps; ++k) iterations += formulation.step(s, h, static_cast<double>(k) * h);
    const double exact = std::sin(four_bar::exact(loops, end).angle);
    EXPECT_LE(std::abs(s.q[0] - exact), 1.05 * std::abs(theirs - exact)) << loops;
    EXPECT_EQ(iterations, steps) << loops;
  }
}

TEST(Index3, KeepsConstraintsOfPositionVelocityAndAcceleration) {
  Mechanism linkage(read_mechanism("linkage", four_bar::text(3)));
  const State s = run(linkage, {}, 1e-3, 0.4);
  const Structure& structure = linkage.structure();
  Eigen::VectorXd phi(structure.constraints), jacobian(structure.jacobian_values()), rate(phi), gamma(phi);
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
/// accelerations have settled to 1e-12 of themselves, but for what the projection has left, below
/// tolerance / h^2; the multipliers (of a rod whose gradient is 2, with a mass of 2 kg) are off by as much.
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
    const double allowed = 1e-11 * s.a.norm() + 1e-10 / (h * h);
    EXPECT_LT((s.a - expected.a).norm(), allowed);
    EXPECT_LT((s.lambda - expected.lambda).norm(), allowed);
  }
}

/// A force of 1 N that begins where the rods of one loop lie in line: each rod has 1 kg, so no point is
/// accelerated by more than 1 N / (1/6 kg), and twice that where it pushes the other along.
TEST(Index3, AForceThatBeginsInTheFlatPositionAcceleratesByNoMoreThanItCan) {
  struct Source final : InputSource {
    void at(double, std::span<InputValue> values) override { values[0] = {force}; }
    double force = 0.0;
  } source;
  Mechanism linkage(
      read_mechanism("linkage", four_bar::text(1) +
                                    "\n[inputs]\nF = { unit = 'N' }\n"
                                    "[forces]\nf = { point = 'B0', direction = [1, 1], magnitude = 'F' }\n"));
  linkage.set_inputs(&source);
  Index3 formulation(linkage, {.penalty = 1e10});
  State s = linkage.described_state();
  formulation.start(s);
  constexpr double h = 1e-4;
  for (int k = 1; k <= 7300; ++k) {
    formulation.step(s, h, k * h);
    if (k < 6900) continue;
    State pushed = s;
    const auto memory = test::memory_of(formulation);
    source.force = 1.0;
    formulation.refresh(pushed);
    EXPECT_LT((pushed.a - s.a).norm(), 12.0) << s.time;
    source.force = 0.0;
    formulation.recall(memory);
  }
}

/// A pendulum of 1 m released at an angle, after 5.25 periods: by how much of its period it is late.
double lateness(double beta, double angle, int steps) {
  test::DrivenPendulum pendulum({.spring = 0.0, .damper = 0.0, .amplitude = 0.0});
  Index3 formulation(pendulum, {.penalty = 2e9, .beta = beta, .tolerance = 1e-13, .projections = 4});
  const double end = 5.25 * 4.0 * std::comp_ellint_1(std::sin(angle / 2.0)) / std::sqrt(9.81);
  State s = pendulum.at(0.0, angle, 0.0);
  formulation.start(s);
  for (int k = 1; k <= steps; ++k) formulation.step(s, end / steps, k * end / steps);
  const double left = std::atan2(s.q[0], -s.q[1]), rate = s.v[0] * -s.q[1] + s.v[1] * s.q[0];
  return -left / rate / end;
}

/// With beta = 1/12 the period's error is of order 4 for small motions only. Projections make the method, for
/// a pendulum without damping, that of
///   theta'' = f + h^2 [(beta - 1/12) f'' - 3 beta theta'^2 f],  f = -g sin theta,
/// so what is left with beta = 1/12 is 3 beta h^2 (A w)^2/8 = h^2 (A w)^2/32 of a period, A the amplitude and
/// w^2 = g (docs/formulations/index3.md has the derivation); with beta = 1/4 it is h^2 w^2/12 besides.
TEST(Index3, HasAPeriodErrorOfOrderFourWithBetaOneTwelfthInSmallMotionsOnly) {
  constexpr double twelfth = 1.0 / 12.0;
  const auto order_with = [](double beta, double angle, int steps) {
    return std::log2(lateness(beta, angle, steps) / lateness(beta, angle, 2 * steps));
  };
  EXPECT_NEAR(order_with(twelfth, 0.003, 100), 4.0, 0.2);
  EXPECT_NEAR(order_with(twelfth, 0.1, 800), 2.0, 0.2);
  EXPECT_NEAR(order_with(0.25, 0.003, 100), 2.0, 0.2);
  const double h = 5.25 * 4.0 * std::comp_ellint_1(std::sin(0.05)) / std::sqrt(9.81) / 1600;
  EXPECT_NEAR(lateness(twelfth, 0.1, 1600) / (h * h * 0.01 * 9.81), 1.0 / 32.0, 0.001);
  EXPECT_NEAR(lateness(0.25, 0.003, 1600) / (h * h * 9.81), 1.0 / 12.0, 0.001);
}

/// With a penalty that holds nothing the iteration ends at once, and the rod grows longer.
TEST(Index3, SaysThatAConstraintIsLost) {
  test::DrivenPendulum pendulum({});
  Index3 formulation(pendulum, {.penalty = 1.0});
  State s = pendulum.at(0.0, 1.0, 0.5);
  formulation.start(s);
  EXPECT_TRUE(
      test::refuses(ErrorCode::numerical, {"constraint 'rod' is lost at t = ", "off by", "0.01"}, [&] {
        for (int k = 1; k <= 5000; ++k) formulation.step(s, 1e-4, 1e-4 * k);
      }));
  EXPECT_LT(s.time, 0.5);
}

/// Projections go on until a change of velocities is below 1e-11 m in 0.25 ms. Each leaves
/// 1/(1 + beta h^2 alpha sigma^2) of an error, with sigma^2 up to 15 at least a quarter: the residual is then
/// at most |Phi_q| = 2.8 times that change.
TEST(Index3, ProjectsUntilVelocitiesAreAsExactAsPositions) {
  Mechanism linkage(read_mechanism("linkage", four_bar::text(5)));
  const auto left = [&](int projections) {
    const Index3Settings settings{.penalty = 1e7, .tolerance = 1e-11, .projections = projections};
    return residuals(linkage, run(linkage, settings, 2.5e-4, 0.5)).velocity;
  };
  EXPECT_GT(left(1), 2.8 * 4e-8);
  EXPECT_LT(left(10), 2.8 * 4e-8);
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
  EXPECT_TRUE(refused({.tolerance = -1.0}, {"tolerance is -1"}));
  EXPECT_TRUE(refused({.most_iterations = 0}, {"most_iterations is 0"}));
  EXPECT_TRUE(refused({.solver = "kul"}, {"'kul'", "'klu'"}));
}

}  // namespace
}  // namespace tandem::mbs
