// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "split_pendulum/experiment.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "refusal.hpp"

namespace tandem::split_pendulum {
namespace {

double largest_error(const Case& c) {
  const Outcome outcome = run_case(c, Truth(c.rods, t_stop));
  EXPECT_TRUE(outcome.stable) << outcome.note;
  return outcome.largest;
}

TEST(SplitPendulum, TheWholeOneIsOfOrderTwo) {
  Case c{{.schedule = "monolithic"}};
  const double coarse = largest_error(c);
  c.step /= 2.0;
  EXPECT_NEAR(std::log2(coarse / largest_error(c)), 2.0, 0.2);
}

/// The figures of the card, with a quarter of the lower rod's mass carried, which is what resists at the
/// start.
TEST(SplitPendulum, IsOfOrderTwoWithTheCarriedMass) {
  for (const auto& [schedule, fast] : {std::pair{"slowest-first", "lower"}, {"fastest-first", "upper"}}) {
    Case c{{schedule, "lagrange4", "lagrange1", fast}, {0.1, 0.025}};
    const double coarse = largest_error(c);
    EXPECT_LT(coarse, 6e-5);
    c.step /= 2.0;
    EXPECT_NEAR(std::log2(coarse / largest_error(c)), 2.0, 0.2) << schedule;
  }
}

/// As much mass below as above: what is felt of it at the elbow is up to three times what the upper rod has
/// there.
TEST(SplitPendulum, EqualMassesNeedAllOfTheLowerOneCarried) {
  Case c{{"slowest-first", "lagrange3", "lagrange1", "upper"}, {1.0}};
  const Truth truth(c.rods, t_stop);
  EXPECT_FALSE(run_case(c, truth).stable);
  c.rods.carried_mass = 1.0;
  EXPECT_TRUE(run_case(c, truth).stable);
}

/// a_(n+1) = -mu (extrapolation of a_n, a_(n-1), .. by degree d): the root of alternating sign reaches -1 at
/// mu = 1/(2^(d+1) - 1). The rest is growth that 1000 steps do not show.
TEST(StableMassRatio, IsThatOfAnExtrapolatedAcceleration) {
  Scheme s{"fastest-first", "lagrange3", "", "upper"};
  for (int degree = 0; degree <= 3; ++degree) {
    s.to_upper = "lagrange" + std::to_string(degree);
    const double limit = 1.0 / (std::pow(2.0, degree + 1) - 1.0);
    EXPECT_NEAR(stable_mass_ratio(s), limit, 0.1 * limit) << degree;
  }
}

TEST(SplitPendulum, RefusesASchemeThatCanNotBeHonoured) {
  const Case c{{"slowest-first", "hermite", "mean"}};
  EXPECT_TRUE(test::refuses(ErrorCode::not_supported, {"mean", "upper.Fx"},
                            [&] { run_case(c, Truth(c.rods, t_stop)); }));
}

}  // namespace
}  // namespace tandem::split_pendulum
