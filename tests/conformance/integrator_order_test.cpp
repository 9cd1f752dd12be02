// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Order of the integrators of diagrams with fixed steps, also across an event; errors of the others by
// tolerance.
#include <gtest/gtest.h>

#include <cmath>

#include "diagram_run.hpp"
#include "word.hpp"

namespace tandem::engine {
namespace {

struct Problem {
  const char *name, *text;
  double t, exact;  ///< of the first output
};
/// x'' = -x; and x' = -x down to x = 1/2, where the rate jumps, then x' = 1/2 - 3 x.
const Problem
    oscillator = {"oscillator",
                  "[blocks]\nx = { kind = 'integrator', input = 'v', initial = 1 }\n"
                  "v = { kind = 'integrator', input = 'a' }\n"
                  "a = { kind = 'gain', input = 'x', gain = -1 }\n[outputs]\nx = { unit = 'm' }\n",
                  2.0, std::cos(2.0)},
    bend = {"bend",
            "[blocks]\nx = { kind = 'integrator', input = 'rate', initial = 1 }\n"
            "slow = { kind = 'gain', input = 'x', gain = -1 }\n"
            "fast = { kind = 'gain', input = 'x', gain = -3, offset = 0.5 }\n"
            "rate = { kind = 'switch', control = 'x', threshold = 0.5, above = 'slow', below = 'fast' }\n"
            "[outputs]\nx = { unit = '1' }\n",
            2.0, 1.0 / 6.0 + std::exp(-3.0 * (2.0 - std::log(2.0))) / 3.0};

double error(const Problem& problem, const IntegratorSettings& settings, int steps) {
  test::DiagramRun run(problem.text, settings);
  run.run(problem.t, steps);
  return std::abs(run.simulation.output(0) - problem.exact);
}

using Case = std::tuple<const char*, Problem>;
std::string name_of(const testing::TestParamInfo<Case>& info) {
  return test::word(std::string(std::get<0>(info.param)) + "_" + std::get<1>(info.param).name);
}

class OrderOfFixedSteps : public testing::TestWithParam<Case> {};

TEST_P(OrderOfFixedSteps, IsFour) {
  const auto& [integrator, problem] = GetParam();
  const double coarse = error(problem, {.name = integrator}, 23),
               fine = error(problem, {.name = integrator}, 46);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.3) << coarse << ", " << fine;
}

INSTANTIATE_TEST_SUITE_P(Integrators, OrderOfFixedSteps,
                         testing::Combine(testing::Values("rk4", "erkstep_fixed"),
                                          testing::Values(oscillator, bend)),
                         name_of);

class ErrorByTolerance : public testing::TestWithParam<Case> {};

TEST_P(ErrorByTolerance, FallsWithIt) {
  const auto& [integrator, problem] = GetParam();
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const double now =
        error(problem,
              {.name = integrator,
               .adaptive = {.relative_tolerance = tolerance, .absolute_tolerance = 1e-2 * tolerance}},
              1);
    EXPECT_LT(now, 50.0 * tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Integrators, ErrorByTolerance,
                         testing::Combine(testing::Values("cvode_adams", "cvode_bdf", "erkstep", "arkstep"),
                                          testing::Values(oscillator, bend)),
                         name_of);

}  // namespace
}  // namespace tandem::engine
