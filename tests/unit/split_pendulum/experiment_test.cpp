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

/// With all steps halved.
double order(Case c, double coarse) {
  c.step /= 2.0;
  return std::log2(coarse / largest_error(c));
}

TEST(SplitPendulum, TheWholeOneIsOfOrderTwo) {
  const Case c{{.schedule = "monolithic"}};
  EXPECT_NEAR(order(c, largest_error(c)), 2.0, 0.2);
}

/// The figures of the card, with a quarter of the lower rod's mass carried, which is what resists at the
/// start.
TEST(SplitPendulum, IsOfOrderTwoWithTheCarriedMass) {
  struct Expected {
    Scheme scheme;
    double error;
  };
  for (const Expected& e : {Expected{{"slowest-first", "lagrange4", "lagrange1", "lower"}, 6e-5},
                            Expected{{"fastest-first", "lagrange4", "lagrange1", "upper"}, 6e-5},
                            Expected{{"fastest-first", "lagrange4", "lagrange4", "lower"}, 6e-5},
                            Expected{{"fastest-first", "least_squares3_2", "mean", "lower"}, 2e-4}}) {
    const Case c{e.scheme, {0.1, 0.025}};
    const double coarse = largest_error(c);
    EXPECT_LT(coarse, e.error) << e.scheme.to_upper;
    EXPECT_NEAR(order(c, coarse), 2.0, 0.2) << e.scheme.to_upper;
  }
}

/// Whatever the steps: what the lower rod resists is the elbow's acceleration.
TEST(SplitPendulum, IsLostWithADisplacementThatHasNoAcceleration) {
  const Truth truth({}, t_stop);
  for (const Scheme& s :
       {Scheme{"slowest-first", "lagrange0", "lagrange1"}, Scheme{"slowest-first", "lagrange1", "lagrange1"},
        Scheme{"fastest-first", "least_squares1_2", "mean"},
        Scheme{"slowest-first", "matched_hold", "matched_hold"},
        Scheme{"fastest-first", "matched_hold", "matched_hold"},
        Scheme{"staggered", "matched_hold", "matched_hold"}})
    for (const double step : {1e-3, 5e-4}) {
      const Outcome outcome = run_case({s, {}, step}, truth);
      EXPECT_TRUE(outcome.note.starts_with("lost at ")) << s.to_lower << ": " << outcome.note;
    }
}

/// A lag costs an order, and an error that grows with it; 1.6e-4 m is there without one, so the ratio of the
/// errors of ten small steps late and one is within 2.5 of 10.
TEST(SplitPendulum, ALateForceIsOfOrderOne) {
  Scheme memory{"fastest-first", "lagrange3", "lagrange1"}, delay = memory;
  memory.lag = Lag::memory, delay.lag = Lag::delay;
  const double late = largest_error({delay});
  EXPECT_EQ(largest_error({memory}), late);  // the reader's step is the communication step
  EXPECT_NEAR(order({delay}, late), 1.0, 0.2);
  memory.fast = delay.fast = "upper";
  EXPECT_NEAR(largest_error({delay}) / largest_error({memory}), 10.0, 2.5);
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
  for (int degree = 0; degree <= 4; ++degree) {
    s.to_upper = "lagrange" + std::to_string(degree);
    const double limit = 1.0 / (std::pow(2.0, degree + 1) - 1.0);
    EXPECT_NEAR(stable_mass_ratio(s), limit, 0.1 * limit) << degree;
  }
}

/// One step late, the force at the end of the step is its newest sample at any degree: a_(n+1) = -mu a_n.
TEST(StableMassRatio, IsOneWithTheNewestAcceleration) {
  Scheme s{"fastest-first", "lagrange3", "", "upper"};
  s.ratio = 1.0;
  for (const Lag lag : {Lag::memory, Lag::delay})
    for (int degree = 0; degree <= 4; ++degree) {
      s.lag = lag, s.to_upper = "lagrange" + std::to_string(degree);
      EXPECT_NEAR(stable_mass_ratio(s), 1.0, 0.1) << degree;
    }
}

TEST(SplitPendulum, RefusesASchemeThatCanNotBeHonoured) {
  const Truth truth({}, t_stop);
  EXPECT_TRUE(test::refuses(ErrorCode::not_supported, {"mean", "upper.Fx"}, [&] {
    run_case({{"slowest-first", "hermite", "mean"}}, truth);
  }));
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"hermite", "lower.Rx gives no derivative"}, [&] {
    run_case({{"slowest-first", "lagrange4", "hermite"}}, truth);
  }));
}

}  // namespace
}  // namespace tandem::split_pendulum
