// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What every stepper does: each formulation with each integrator, as they come from make_stepper().
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <limits>

#include "driven_pendulum.hpp"
#include "refusal.hpp"
#include "small_models.hpp"
#include "standing_linkage.hpp"
#include "stepper_errors.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/residuals.hpp"

namespace tandem::mbs {
namespace {

using test::DrivenPendulum;
using test::errors;
using test::expect_order;
using test::Fading;
using test::Thrown;

class EachStepper : public testing::TestWithParam<StepperNames> {
 protected:
  static std::unique_ptr<Stepper> make(Model& model) {
    StepperSettings settings;
    settings.formulation = GetParam().formulation;
    settings.integrator = GetParam().integrator;
    if (settings.formulation == "index3") settings.index3.tolerance = 1e-12;
    return make_stepper(model, settings);
  }
  static double order() { return test::order_of(GetParam().integrator); }
  /// By the order: steps of which the error stands out of rounding and of a penalty's own.
  template <class Value>
  static Value by_order(Value two, Value four, Value eight) {
    return order() > 4.0 ? eight : order() > 2.0 ? four : two;
  }

  /// `steps` steps to `end`, from a state of which a and lambda are to be found.
  static State run(Model& model, State s, double end, int steps) {
    const auto stepper = make(model);
    s.a.setZero();
    stepper->start(s);
    for (int k = 1; k <= steps; ++k) stepper->step(s, end / steps, k * end / steps);
    return s;
  }
};
INSTANTIATE_TEST_SUITE_P(Each, EachStepper, testing::ValuesIn(stepper_names()),
                         [](const auto& p) { return p.param.formulation + "_" + p.param.integrator; });

constexpr int checkpoints = 8;

/// A penalty of 2e7 leaves lambda/alpha = 3e-7 of Phi'' and as much of a; lambda is known to alpha times the
/// rounding of a, 2e7 1e-15.
TEST_P(EachStepper, StartsWithTheAccelerationsAndMultipliersOfTheState) {
  DrivenPendulum pendulum({});
  const State exact = pendulum.at(0.7, 1.0, 0.5);
  State s = exact;
  s.a.setZero();
  s.lambda.setZero();
  make(pendulum)->start(s);
  EXPECT_LT((s.a - exact.a).norm(), 1e-6);
  EXPECT_LT((s.lambda - exact.lambda).norm(), 1e-6);
  EXPECT_EQ(s.q, exact.q);
  EXPECT_EQ(s.v, exact.v);
}

/// Forces that depend on positions and velocities, a constraint that depends on time. The swing is one in
/// which null_space keeps its coordinates: where it changes them depends on the step, and so does the error.
TEST_P(EachStepper, IsOfItsOrderOnADrivenPendulum) {
  DrivenPendulum pendulum({});
  const State first = pendulum.at(0.0, 0.4, 1.0);
  std::vector<State> exact;
  const double end = by_order(1.0, 1.0, 2.0);
  for (int k = 1; k <= checkpoints; ++k) exact.push_back(pendulum.exact(end * k / checkpoints, 0.4, 1.0));
  const int steps = by_order(128, 32, 8);
  expect_order(errors(*make(pendulum), first, exact, steps), errors(*make(pendulum), first, exact, 2 * steps),
               order());
}

/// The four-bar linkage before its flat position, or hanging, for order 8.
TEST_P(EachStepper, IsOfItsOrderOnTheLinkage) {
  const auto start = by_order(four_bar::Start::upright, four_bar::Start::upright, four_bar::Start::hanging);
  const double end = by_order(0.5, 0.5, 2.8);
  Mechanism linkage(read_mechanism("linkage", four_bar::text(2, start)));
  const State first = linkage.described_state();
  std::vector<State> exact;
  for (const four_bar::Crank& crank : four_bar::exact_path(2, start, end / checkpoints, checkpoints)) {
    exact.push_back(test::standing(linkage, crank));
    exact.back().time = end / checkpoints * static_cast<double>(exact.size() - 1);
  }
  exact.erase(exact.begin());
  const int steps = by_order(64, 16, 8);
  expect_order(errors(*make(linkage), first, exact, steps), errors(*make(linkage), first, exact, 2 * steps),
               order());
}

/// The largest change of the energy in 2 s.
double drift(Stepper& stepper, Model& model, State s, int steps) {
  stepper.start(s);
  const double first = model.energy(s.q.data(), s.v.data());
  double worst = 0.0;
  for (int k = 1; k <= steps; ++k) {
    stepper.step(s, 2.0 / steps, k * 2.0 / steps);
    worst = std::max(worst, std::abs(model.energy(s.q.data(), s.v.data()) - first));
  }
  return worst;
}

/// It may fall faster than the order: some methods keep the energy better than the motion.
TEST_P(EachStepper, DriftsInEnergyByItsOrderAtMost) {
  DrivenPendulum pendulum({.damper = 0.0, .amplitude = 0.0});
  const State s = pendulum.at(0.0, 0.6, 0.5);
  const int steps = by_order(200, 100, 8);
  const double coarse = drift(*make(pendulum), pendulum, s, steps),
               fine = drift(*make(pendulum), pendulum, s, 2 * steps);
  EXPECT_GT(std::log2(coarse / fine), order() - test::order_slack(order())) << coarse << " " << fine;
}

/// Residuals of formulations that don't satisfy constraints exactly are errors of the motion, so they fall by
/// the order, down to what the penalty leaves: lambda/(alpha omega^2) = 3e-9 m^2 in positions, omega times
/// as much in velocities, omega^2 times in accelerations.
TEST_P(EachStepper, SatisfiesConstraintsOfPositionVelocityAndAcceleration) {
  DrivenPendulum pendulum({});
  const State first = pendulum.at(0.0, 1.0, 0.5);
  const Residuals coarse = residuals(pendulum, run(pendulum, first, 1.0, 100)),
                  fine = residuals(pendulum, run(pendulum, first, 1.0, 200));
  const double falls = std::pow(2.0, order() - 0.3);
  EXPECT_LT(fine.position, std::max(coarse.position / falls, 1e-8));
  EXPECT_LT(fine.velocity, std::max(coarse.velocity / falls, 1e-7));
  EXPECT_LT(fine.acceleration, std::max(coarse.acceleration / falls, 1e-5));
}

TEST_P(EachStepper, GivesTheSameBitsInEachRun) {
  DrivenPendulum pendulum({});
  const State first = pendulum.at(0.0, 1.0, 0.5), a = run(pendulum, first, 1.0, 50),
              b = run(pendulum, first, 1.0, 50);
  EXPECT_EQ(a.q, b.q);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.a, b.a);
  EXPECT_EQ(a.lambda, b.lambda);
}

/// As start() gives them, but for the rounding of alpha times the change of a, 2e7 4 2e-16.
TEST_P(EachStepper, RefreshesAccelerationsAndMultipliersForANewInput) {
  DrivenPendulum pendulum({});
  const auto stepper = make(pendulum);
  State s = pendulum.at(0.0, 1.0, 0.5);
  stepper->start(s);
  for (int k = 1; k <= 20; ++k) stepper->step(s, 1e-2, k * 1e-2);
  pendulum.input = 7.0;
  State expected = s;
  stepper->refresh(s);
  make(pendulum)->start(expected);
  EXPECT_LT((s.a - expected.a).norm(), 1e-7);
  EXPECT_LT((s.lambda - expected.lambda).norm(), 1e-6);
  EXPECT_EQ(s.q, expected.q);
  EXPECT_EQ(s.v, expected.v);
}

TEST_P(EachStepper, NamesTheVariableAndTheTimeOfAForceThatIsNotANumber) {
  DrivenPendulum pendulum({});
  const auto stepper = make(pendulum);
  State s = pendulum.at(0.0, 1.0, 0.5);
  stepper->start(s);
  stepper->step(s, 0.015625, 0.015625);
  pendulum.input = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::string> says = {"force on bob.x is nan", "at t = 0."};
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, says, [&] { stepper->step(s, 0.015625, 0.03125); }));
}

TEST_P(EachStepper, NamesVariableConstraintAndTimeOfASingularTangent) {
  DrivenPendulum massless({.mass = 0.0});
  State s = massless.at(0.5, 0.0, 0.0);  // hanging: nothing holds x
  s.a.setZero();
  const std::vector<std::string> says = {"singular at t = 0.5 s", "bob.x", "rod"};
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, says, [&] { make(massless)->start(s); }));
}

TEST_P(EachStepper, NamesTheConstraintAndTheTimeWhereARowOfTheJacobianVanishes) {
  Fading model;
  State s{0.0, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(),
          Eigen::Vector2d::Zero()};
  const auto stepper = make(model);
  stepper->start(s);
  for (int k = 1; k < 8; ++k) stepper->step(s, 0.125, 0.125 * k);
  EXPECT_TRUE(
      test::refuses(ErrorCode::numerical, {"'fading'", "t = 1 s"}, [&] { stepper->step(s, 0.125, 1.0); }));
}

TEST_P(EachStepper, MovesWhatHasNoConstraints) {
  Thrown model;
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  const State s = run(model, {0.0, one, 4.0 * one, one, Eigen::VectorXd()}, 2.0, 16);
  EXPECT_NEAR(s.q[0], 3.0, 1e-12);  // 1 + 4 t - 3/2 t^2
  EXPECT_NEAR(s.v[0], -2.0, 1e-12);
  EXPECT_NEAR(s.a[0], -3.0, 1e-12);
}

/// Nothing is projected, and nothing grows.
TEST(Index3, MovesWhatHasNoConstraintsWithBetaBelowAQuarterToo) {
  Thrown model;
  Index3 stepper(model, {.beta = 1.0 / 12.0});
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  State s{0.0, one, 4.0 * one, one, Eigen::VectorXd()};
  stepper.start(s);
  for (int k = 1; k <= 16; ++k) stepper.step(s, 0.125, 0.125 * k);
  EXPECT_NEAR(s.q[0], 3.0, 1e-12);
}

TEST_P(EachStepper, RefusesAStepThatIsNotAboveZero) {
  DrivenPendulum pendulum({});
  State s = pendulum.at(0.0, 1.0, 0.5);
  const auto stepper = make(pendulum);
  stepper->start(s);
  for (const double h : {0.0, -0.1, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_TRUE(
        test::refuses(ErrorCode::invalid_argument, {"step is"}, [&] { stepper->step(s, h, s.time + h); }));
}

#if defined(__SSE2__)
/// A pendulum that comes to rest: x falls by exp(-3 t) and would pass through the denormal numbers, below
/// 2e-308, from t = 236 s on, where each operation takes many times as long. It stops above them, as changes
/// that small count as zero; outside of a step they are as ever.
TEST_P(EachStepper, LeavesNoDenormalsInAMotionThatDiesOut) {
  DrivenPendulum pendulum({.spring = 0.0, .damper = 12.0, .amplitude = 0.0});
  const State s = run(pendulum, pendulum.at(0.0, 1.0, 0.0), 260.0, 10400);
  EXPECT_LT(std::abs(s.q[0]), 1e-300);
  for (const Eigen::VectorXd* x : {&s.q, &s.v, &s.a, &s.lambda})
    for (const double value : *x) EXPECT_NE(std::fpclassify(value), FP_SUBNORMAL);
  volatile double least = DBL_MIN;
  EXPECT_GT(least / 2.0, 0.0);
}
#endif

}  // namespace
}  // namespace tandem::mbs
