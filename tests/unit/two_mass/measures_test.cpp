// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "two_mass/experiment.hpp"

namespace tandem::two_mass {
namespace {

// The fast mode has grown 128-fold, so x1 errs by some ten times the motion; the thesis' measure says FR/N.
TEST(PositionError, OfARunThatHasGrownSaturatesUnlessItGoesByTheExactMotion) {
  const Case grown{{"parallel", "lagrange2", "lagrange0"}, 27.1};
  run_case(grown, [](const Model& model, const Measures& measures) {
    double errors = 0.0, exact = 0.0, computed = 0.0;
    for (const auto& n : measures.nodes()) {
      const double x1 = model.exact(n.time).x1;
      errors += (n.x1 - x1) * (n.x1 - x1);
      exact += x1 * x1;
      computed += n.x1 * n.x1;
    }
    ASSERT_GT(computed, 25.0 * exact);
    const Figures f = measures.figures();
    EXPECT_NEAR(f.position_error.value(), 0.271, 0.01);
    EXPECT_NEAR(f.position_error_exact.value() / (0.271 * std::sqrt(errors / exact)), 1.0, 1e-12);
  });
}

TEST(PositionError, OfARightRunIsTheSameByBoth) {
  const Figures f = run_case({{"slowest-first", "lagrange3", "lagrange3"}, 3.0}).figures;
  EXPECT_NEAR(f.position_error_exact.value() / f.position_error.value(), 1.0, 0.01);
}

}  // namespace
}  // namespace tandem::two_mass
