// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What the fixed step evaluates: how often in a step, and in how many trials it finds an event.
#include "tandem/engine/integrators/runge_kutta.hpp"

#include <gtest/gtest.h>

#include <string>

#include "diagram_run.hpp"
#include "tandem/engine/compiled_block.hpp"

namespace tandem::engine {
namespace {

long counted_rates = 0;

/// x' = u - x, which counts how often it is evaluated.
CompiledBlock counting_lag() {
  CompiledBlock block;
  block.kind = "counting_lag";
  block.inputs = {"u"};
  block.outputs = {"x"};
  block.states = {{"x", 1.0}};
  block.output = [](const double*, const double* x, const double*, double* y) { y[0] = x[0]; };
  block.rates = [](const double*, const double* x, const double* u, double* dx) {
    ++counted_rates;
    dx[0] = u[0] - x[0];
  };
  block.feedthrough = false;
  return block;
}

/// A half up to the time of the jump, then 1.
class JumpingInput final : public InputSource {
 public:
  void at(double t, double* u) override { u[0] = t < jump ? 0.5 : 1.0; }
  double jump = 1e9;
};

/// Evaluations in each of four steps of 0.1 s with an input that jumps where the third begins, as a
/// coordinator's hold does: the end of the second is evaluated with the value before.
class CountedSteps : public testing::Test {
 protected:
  CountedSteps() {
    Description d = read_diagram("d",
                                 "[inputs]\nu = { unit = '1' }\n[blocks]\nx = { kind = 'counting_lag', u = "
                                 "'u' }\n[outputs]\nx = { unit = '1', from = 'x.x' }\n");
    d.kinds = {counting_lag()};
    program_ = compile(d);
  }

  std::vector<long> evaluations(bool jumps) const {
    JumpingInput input;
    Simulation s(program_, &input, make_integrator({}));
    s.start(0.0);
    std::vector<long> counts;
    for (int k = 1; k <= 4; ++k) {
      const long before = counted_rates;
      s.run(0.1 * k);
      counts.push_back(counted_rates - before);
      if (jumps && k == 2) input.jump = 0.0;
    }
    return counts;
  }

 private:
  Program program_;
};

/// Three within the step and one at its end, which the next begins with.
TEST_F(CountedSteps, AreOfFourEvaluationsWhereInputsGoOn) {
  EXPECT_EQ(evaluations(false), (std::vector<long>{4, 4, 4, 4}));
}

TEST_F(CountedSteps, AreOfOneMoreWhereAnInputJumps) {
  EXPECT_EQ(evaluations(true), (std::vector<long>{4, 4, 5, 4}));
}

/// In one step of 1 s across x = t = 0.5 s: that step, the secant's, which ends where the signal is zero to
/// the last bit and keeps its sign, one next to it, one to the event, and one for the rest. Halving takes 40.
TEST(RungeKutta, FindsAnEventWhereATrialEndsOnZeroAtOnce) {
  test::DiagramRun run(
      "[blocks]\nx = { kind = 'integrator', input = 1 }\n"
      "s = { kind = 'gain', input = 'x', gain = 1, offset = -0.5 }\n"
      "since = { kind = 'sample', trigger = 's', input = 'time' }\n[outputs]\nsince = { unit = 's' }\n");
  run.run(1.0, 1);
  EXPECT_NEAR(run.simulation.output(0), 0.5, 1e-12);
  EXPECT_EQ(run.simulation.statistics().steps, 5);
}

}  // namespace
}  // namespace tandem::engine
