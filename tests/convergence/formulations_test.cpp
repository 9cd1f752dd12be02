// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What is peculiar to one formulation, and formulations against each other.
#include <gtest/gtest.h>

#include <cmath>

#include "driven_pendulum.hpp"
#include "four_bar/linkage.hpp"
#include "refusal.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/residuals.hpp"

namespace tandem::mbs {
namespace {

using test::DrivenPendulum;

State run(Stepper& stepper, State s, double end, int steps) {
  s.a.setZero();
  stepper.start(s);
  for (int k = 1; k <= steps; ++k) stepper.step(s, end / steps, k * end / steps);
  return s;
}

/// Hanging at rest, Phi'' = Phi' = 0 and alpha omega^2 Phi = lambda.
TEST(Penalty, RestsWhereConstraintsGiveWayByLambdaOverAlphaOmegaSquared) {
  DrivenPendulum pendulum({.spring = 0.0, .damper = 5.0, .amplitude = 0.0});
  StepperSettings settings;
  settings.formulation = "penalty";
  settings.integrator = "rk4";
  settings.penalty = {.penalty = 1e4, .omega = 5.0};
  const State s = run(*make_stepper(pendulum, settings), pendulum.at(0.0, 0.0, 0.0), 20.0, 2000);
  EXPECT_NEAR(residuals(pendulum, s).position, s.lambda[0] / (1e4 * 25.0), 1e-9);
  EXPECT_NEAR(s.lambda[0], 0.5 * 2.0 * 9.81, 1e-3);
}

/// Phi at the end, where the velocity misses its constraint by Phi' = 2e-3 m^2/s at the start. Four digits
/// are more than the method errs by in 100 steps.
double missed(double xi, double omega, double end) {
  DrivenPendulum pendulum({});
  StepperSettings settings;
  settings.formulation = "index1";
  settings.integrator = "rk4";
  settings.index1 = {.xi = xi, .omega = omega};
  State s = pendulum.at(0.0, 0.5, 0.0);
  s.v += 1e-3 * Eigen::Vector2d(std::sin(0.5), -std::cos(0.5));
  s = run(*make_stepper(pendulum, settings), s, end, 100);
  return residuals(pendulum, s).position;
}

/// Phi'' + 2 xi omega Phi' + omega^2 Phi = 0; without Baumgarte's terms Phi'' = 0, and what is missed grows.
TEST(Index1, MovesViolatedConstraintsAsBaumgarteSays) {
  EXPECT_NEAR(missed(0.0, 0.0, 0.5), 2e-3 * 0.5, 1e-6);
  EXPECT_NEAR(missed(1.0, 10.0, 0.2), 2e-3 * 0.2 * std::exp(-2.0), 1e-7);
  EXPECT_NEAR(missed(0.0, 10.0, 0.1), 2e-4 * std::sin(1.0), 1e-7);
}

TEST(Index1, SaysWhenItsMultipliersDoNotSettle) {
  DrivenPendulum pendulum({});
  State s = pendulum.at(0.5, 1.0, 0.5);
  s.a.setZero();
  Index1 formulation(pendulum, {.penalty = 1.0, .multiplier_iterations = 3});
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, {"not settled at t = 0.5 s in 3 iterations"},
                            [&] { formulation.start(s); }));
}

TEST(Index1, GivesTheSameWithMultipliersThatAreCarriedOn) {
  DrivenPendulum pendulum({});
  StepperSettings settings;
  settings.formulation = "index1";
  const State zero = run(*make_stepper(pendulum, settings), pendulum.at(0.0, 1.0, 0.5), 1.0, 100);
  settings.index1.carry_multipliers = true;
  const State carried = run(*make_stepper(pendulum, settings), pendulum.at(0.0, 1.0, 0.5), 1.0, 100);
  EXPECT_LT((zero.q - carried.q).norm(), 1e-9);
  EXPECT_LT((zero.lambda - carried.lambda).norm(), 1e-5);
}

/// The linkage of one loop with a stay that says what its rods say already: forces are shared out evenly (the
/// multipliers of the least norm), in all formulations.
TEST(Formulations, AgreeOnAMechanismWithARedundantConstraint) {
  const auto text = four_bar::text(1) + "\n[distances.stay]\npoints = [\"A0\", \"B0\"]\n";
  Mechanism linkage(read_mechanism("linkage", text));
  const auto find = [&](const char* formulation) {
    StepperSettings settings;
    settings.formulation = formulation;
    return run(*make_stepper(linkage, settings), linkage.described_state(), 0.4, 400);
  };
  const State expected = find("null_space");
  for (const char* formulation : {"index3", "index1", "penalty"}) {
    const State s = find(formulation);
    EXPECT_LT((s.q - expected.q).norm(), 1e-5) << formulation;
    EXPECT_LT((s.lambda - expected.lambda).norm(), 1e-3) << formulation;
  }
  EXPECT_NEAR(expected.lambda[0], expected.lambda[3], 1e-9) << "the rod and its stay";
}

/// The pendulum goes round, so that x and y take turns. Where they do depends on the step, so the error's
/// factor varies (by 2): over four halvings that is 0.25 of an order.
TEST(NullSpace, KeepsItsOrderWhereItChangesCoordinates) {
  DrivenPendulum pendulum({});
  const State exact = pendulum.exact(1.0, 1.0, 7.0, 2e-4);
  EXPECT_GT(std::abs(pendulum.exact(0.5, 1.0, 7.0).q[1] - pendulum.at(0.0, 1.0, 7.0).q[1]), 1.0);
  for (const auto& [integrator, order, steps] : {std::tuple{"rk4", 4.0, 100}, std::tuple{"newmark", 2.0, 200},
                                                 std::tuple{"generalized_alpha", 2.0, 200}}) {
    StepperSettings settings;
    settings.formulation = "null_space";
    settings.integrator = integrator;
    const auto error = [&](int n) {
      return (run(*make_stepper(pendulum, settings), pendulum.at(0.0, 1.0, 7.0), 1.0, n).q - exact.q).norm();
    };
    EXPECT_NEAR(0.25 * std::log2(error(steps) / error(16 * steps)), order, 0.25) << integrator;
  }
}

/// Position constraints hold to Newton's tolerance, the others to rounding.
TEST(NullSpace, HoldsConstraintsToRounding) {
  Mechanism linkage(read_mechanism("linkage", four_bar::text(3)));
  StepperSettings settings;
  settings.formulation = "null_space";
  const Residuals r =
      residuals(linkage, run(*make_stepper(linkage, settings), linkage.described_state(), 0.5, 100));
  EXPECT_LT(r.position, 1e-12);
  EXPECT_LT(r.velocity, 1e-10);
  EXPECT_LT(r.acceleration, 1e-9);
}

}  // namespace
}  // namespace tandem::mbs
