// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "functions/ways.hpp"

#include <gtest/gtest.h>

#include "functions/double_pendulum.hpp"
#include "mechanisms/double_pendulum.hpp"

namespace tandem::functions {
namespace {

bool needs_octave(const Way& way) { return way.name == "pipe" || way.name == "mex"; }

#ifdef TANDEM_OCTAVE
constexpr bool octave_is_there = true;
#else
constexpr bool octave_is_there = false;
#endif

/// The four compute the same terms by the same operations, and 17 digits tell a double exactly.
TEST(FunctionEvaluation, EveryWayTakesTheSameIterationsToTheSameBits) {
  const Motion motion{1e-2, 30};
  const Outcome plain = ways().front().run(motion);
  EXPECT_GT(plain.iterations, motion.steps);
  for (const Way& way : ways()) {
    if (needs_octave(way) && !octave_is_there) continue;
    const Outcome o = way.run(motion);
    EXPECT_EQ(o.iterations, plain.iterations) << way.name;
    EXPECT_EQ(o.q, plain.q) << way.name;
    EXPECT_EQ(o.v, plain.v) << way.name;
  }
}

/// The trapezoidal rule's error at 0.5 s falls fourfold with half the step.
TEST(FunctionEvaluation, TheDoublePendulumMovesAsItsEquationsSay) {
  const auto truth = mechanisms::double_pendulum(0.5);
  const auto error = [&](const Motion& m) {
    const Outcome o = ways().front().run(m);
    return (o.q - (Eigen::VectorXd(4) << truth.elbow, truth.tip).finished()).norm();
  };
  const double coarse = error({1e-2, 50}), fine = error({5e-3, 100});
  EXPECT_LT(coarse, 1e-2);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2);
}

}  // namespace
}  // namespace tandem::functions
