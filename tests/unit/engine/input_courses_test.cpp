// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Adaptive integrators and inputs that jump or bend; what they count.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tandem/engine/compile.hpp"
#include "tandem/engine/make_integrator.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/simulation.hpp"
#include "word.hpp"

namespace tandem::engine {
namespace {

/// (k + 1) times t to the power of `degree` in the stretch number k of 0.3 s; notes the latest time asked
/// for.
class Stretches final : public InputSource {
 public:
  explicit Stretches(int degree) : degree_(degree) {}
  double begin_course(double t) override {
    while (end(stretch_) <= t) ++stretch_;
    follows_ = true;
    return end(stretch_);
  }
  void at(double t, double* u) override {
    if (follows_) past_end = std::max(past_end, t - end(stretch_));
    u[0] = (stretch_ + 1) * std::pow(t - 0.3 * stretch_, degree_);
  }
  double past_end = -std::numeric_limits<double>::infinity();

 private:
  static double end(int k) { return 0.3 * (k + 1); }
  int degree_, stretch_ = 0;
  bool follows_ = false;
};

const std::string lag =
    "[inputs]\nu = { unit = '1' }\n[blocks]\nx = { kind = 'lag', input = 'u', time = 1 }\n[outputs]\nx = { "
    "unit = "
    "'1' }\n";

class Adaptive : public testing::TestWithParam<std::string> {
 protected:
  Adaptive() {
    settings.name = GetParam();
    if (settings.name != "erkstep_fixed")
      settings.adaptive = {.relative_tolerance = 1e-9, .absolute_tolerance = 1e-12};
  }
  IntegratorSettings settings;
  Program program = compile(read_diagram("d", lag));
};

/// x' = u - x with u = 1, 2, 3, ..: from x at its beginning to u + (x - u) e^-0.3 in each stretch.
TEST_P(Adaptive, FollowsJumpsOfItsInputs) {
  Stretches inputs(0);
  Simulation s(program, &inputs, make_integrator(settings));
  s.start(0.0);
  for (int k = 1; k <= 120; ++k) s.run(0.025 * k);
  double x = 0.0;
  for (int k = 1; k <= 10; ++k) x = k + (x - k) * std::exp(-0.3);
  EXPECT_NEAR(s.output(0), x, settings.name == "erkstep_fixed" ? 1e-6 : 2e-8);
  EXPECT_LE(inputs.past_end, 1e-12);  // the rounding of time
}

TEST_P(Adaptive, NeverAsksBeyondTheTimeThatItIsAskedFor) {
  class Watched final : public InputSource {
   public:
    void at(double t, double* u) override { latest = std::max(latest, t), u[0] = std::sin(t); }
    double latest = 0.0;
  } inputs;
  Simulation s(program, &inputs, make_integrator(settings));
  s.start(0.0);
  for (int k = 1; k <= 50; ++k) {
    s.run(0.1 * k);
    EXPECT_LE(inputs.latest, 0.1 * k * (1.0 + 1e-14));
  }
}

/// Samples each 0.06 s and jumps each 0.3 s are due at the same times, rounding apart; a first step of that
/// length is none that SUNDIALS takes.
TEST_P(Adaptive, TakesEventsWithinTheRoundingOfTimeTogether) {
  const Program sampled = compile(
      read_diagram("d",
                   "[inputs]\nu = { unit = '1' }\n[blocks]\nx = { kind = 'lag', input = 'u', time = 1 }\n"
                   "y = { kind = 'sample', input = 'x', period = 0.06 }\n[outputs]\ny = { unit = '1' }\n"));
  Stretches inputs(0);
  Simulation s(sampled, &inputs, make_integrator(settings));
  s.start(0.0);
  EXPECT_NO_THROW({
    for (int k = 1; k <= 3000; ++k) s.run(0.01 * k);
  });
}

TEST_P(Adaptive, CountsWhatItDoes) {
  Stretches inputs(1);
  Simulation s(program, &inputs, make_integrator(settings));
  s.start(0.0);
  s.run(3.0);
  const Statistics done = s.statistics();
  EXPECT_GE(done.steps, 10);
  EXPECT_GE(done.rate_evaluations, done.steps);
  const bool is_implicit = settings.name == "arkstep" || settings.name.starts_with("cvode");
  EXPECT_EQ(done.nonlinear_iterations > 0, is_implicit);
  EXPECT_GE(done.restarts, 10);  // at the start, and where u falls to 0
}

/// It knows from the jump before how long a first step may be, unless a state was set since then.
TEST_P(Adaptive, BeginsAnewWithFewerEvaluationsThanAtFirst) {
  const auto evaluations = [&](bool sets_state) {
    Stretches inputs(0);
    Simulation s(program, &inputs, make_integrator(settings));
    s.start(0.0);
    for (int k = 1; k <= 100; ++k) {
      s.run(0.3 * k);
      if (sets_state) s.restore(s.time(), std::vector<double>(s.keep()));
    }
    return static_cast<double>(s.statistics().rate_evaluations) / 100.0;
  };
  const double after_jump = evaluations(false), from_state = evaluations(true);
  RecordProperty("evaluations_a_jump", std::to_string(after_jump));
  RecordProperty("evaluations_a_state", std::to_string(from_state));
  EXPECT_LE(after_jump, from_state);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Adaptive,
                         testing::Values("cvode_adams", "cvode_bdf", "erkstep", "erkstep_fixed", "arkstep"),
                         [](const auto& p) { return test::word(p.param); });

TEST(Statistics, OfTheFixedStepAreFourEvaluationsAStep) {
  const Program program = compile(read_diagram("d", lag));
  Stretches inputs(0);
  Simulation s(program, &inputs, make_integrator({}));
  s.start(0.0);
  for (int k = 1; k <= 10; ++k) s.run(0.1 * k);
  EXPECT_EQ(s.statistics().steps, 10);
  EXPECT_EQ(s.statistics().rate_evaluations, 40);
}

}  // namespace
}  // namespace tandem::engine
