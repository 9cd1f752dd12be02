// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The index-3 formulation where its steps are too long or too short, and where its tangent is indefinite.
#include <gtest/gtest.h>

#include <span>
#include <string>

#include "driven_pendulum.hpp"
#include "memory_of.hpp"
#include "refusal.hpp"
#include "tandem/mbs/formulations/index3.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/residuals.hpp"

namespace tandem::mbs {
namespace {

/// sigma^2 = 4/m = 2: with alpha = 2e7 a projection leaves 1/(1 + 2 beta h^2 alpha), and steps of 2 ms (0.07)
/// are stable with beta = 1/12, which multiplies by 9.9, those of 1.5 ms (0.118) only with two projections.
/// Frequencies sqrt(alpha) sigma h of 13 are beyond 2.449 by far, and don't count.
TEST(Index3, RefusesStepsInWhichProjectionsDoNotKeepUpWithABetaBelowAQuarter) {
  const auto go = [](double h, int projections) {
    test::DrivenPendulum pendulum({.spring = 0.0, .damper = 0.0, .amplitude = 0.0});
    Index3 formulation(pendulum, {.beta = 1.0 / 12.0, .projections = projections});
    State s = pendulum.at(0.0, 1.0, 0.0);
    formulation.start(s);
    for (int k = 1; k <= 1000; ++k) formulation.step(s, h, k * h);
    return residuals(pendulum, s).velocity;
  };
  EXPECT_LT(go(2e-3, 1), 1e-4);
  EXPECT_LT(go(1.5e-3, 2), 1e-4);
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, {"beta = 0.08333", "grow by 9.899", "0.118", "below 0.101"},
                            [&] { go(1.5e-3, 1); }));
}

/// Hanging at rest, a spring of k to (1, 0) and m = 2 kg: sqrt(k/m + ...) rad/s; with k = 1e6 steps of 5 ms
/// are beyond 2.449/omega.
TEST(Index3, RefusesStepsBeyondTheStabilityLimitOfBetaBelowAQuarter) {
  test::DrivenPendulum pendulum({.spring = 1e6, .damper = 0.0, .amplitude = 0.0});
  State s = pendulum.at(0.0, 1.0, 0.0), again = s;
  Index3 formulation(pendulum, {.beta = 1.0 / 12.0}), trapezoidal(pendulum, {.multiplier_iterations = 30});
  formulation.start(s);
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, {"omega h = 2.449", "highest frequency", "step below"},
                            [&] { formulation.step(s, 5e-3, 5e-3); }));
  trapezoidal.start(again);
  trapezoidal.step(again, 5e-3, 5e-3);
}

/// A spring between two points 0.5 m apart that is 2 m long when free: pushed together, it makes M + h^2/4 K
/// indefinite across it, k (1 - 2/0.5) h^2/4 = -3 m. `auto` solves that as KLU does; then it swings out.
TEST(Index3, StepsWithATangentThatIsNotPositiveDefinite) {
  const std::string text =
      "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [0.5, 0], velocity = [0, 0.1] "
      "}\n"
      "[masses]\nm = { point = 'P', mass = 1 }\n[springs]\ns = { points = ['O', 'P'], stiffness = 4e4, free "
      "= 2 }\n";
  const auto end = [&](const std::string& solver) {
    Mechanism m(read_mechanism("spring", text));
    Index3 formulation(m, {.solver = solver});
    State s = initial_state(m, 0.0);
    formulation.start(s);
    for (int k = 1; k <= 40; ++k) formulation.step(s, 0.01, 0.01 * k);
    return s;
  };
  const State automatic = end("auto"), klu = end("klu");
  EXPECT_LT((automatic.q - klu.q).norm(), 1e-9);
  EXPECT_GT(automatic.q.norm(), 1.0);
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, {"singular at t =", "or not positive definite"},
                            [&] { end("lapack"); }));
}

/// What is put back goes on as it would have, whatever kind of tangent came in between.
TEST(Index3, ForgetsATangentThatIsNotPositiveDefiniteWhereAnotherIsPutBack) {
  struct Source final : InputSource {
    void at(double, std::span<InputValue> values) override { values[0] = {force}; }
    double force = 0.0;
  } source;
  Mechanism m(read_mechanism(
      "spring",
      "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [3, 0], velocity = [0, 0.1] }\n"
      "[masses]\nm = { point = 'P', mass = 1 }\n[springs]\ns = { points = ['O', 'P'], stiffness = 4e4, free "
      "= "
      "2 }\n[inputs]\nF = { unit = 'N' }\n[forces]\nf = { point = 'P', direction = [1, 1], magnitude = 'F' "
      "}\n"));
  m.set_inputs(&source);
  Index3 formulation(m, {});
  State stretched = initial_state(m, 0.0), pushed = stretched;
  pushed.q[0] = 1.2,
  pushed.v[0] = -150.0;  // with 8000 m/s^2 to 0.95 m: k (1 - 2/0.95) h^2/4 = -1.1 kg across
  formulation.start(stretched);
  formulation.step(stretched, 0.01, 0.01);
  const auto memory = test::memory_of(formulation);
  State expected = stretched;
  source.force = 1.0;
  formulation.refresh(expected);
  formulation.recall(memory);
  source.force = 0.0;
  pushed.a.setZero();
  pushed.a[0] = 8000.0;
  formulation.step(pushed, 0.01, 0.01);
  ASSERT_EQ(test::memory_of(formulation).front(), 0.0);  // no tangent of use
  formulation.recall(memory);
  source.force = 1.0;
  formulation.refresh(stretched);
  EXPECT_EQ(stretched.a, expected.a);
}

}  // namespace
}  // namespace tandem::mbs
