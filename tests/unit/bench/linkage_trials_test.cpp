// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/linkage_trials.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tandem::bench {
namespace {

using Trials = std::vector<LinkageTrial>;

TEST(LinkageTrials, CostIsInterpolatedBetweenTheLogarithmsOfAMethodsNeighbours) {
  const auto cost = cost_of(Trials{{"simbody", "hanging", "Rod Verlet", "ok", 1, 1e-2, 1e-1},
                                   {"simbody", "hanging", "Rod Verlet", "ok", 1, 1e-4, 1e1},
                                   {"simbody", "hanging", "Rod CPodes", "ok", 1, 1e-1, 1e-2}},
                            1e-3);
  ASSERT_TRUE(cost.has_value());
  EXPECT_NEAR(cost->seconds, 1.0, 1e-12);
  EXPECT_FALSE(cost->bound);
  EXPECT_EQ(cost->method, "Rod Verlet");
}

TEST(LinkageTrials, CostOfACheapestRunThatIsMoreAccurateIsABound) {
  const auto cost = cost_of(Trials{{"tandem", "hanging", "index3 1e-4", "ok", 1, 5e-4, 1e-3}}, 1e-3);
  ASSERT_TRUE(cost.has_value());
  EXPECT_EQ(cost->seconds, 1e-3);
  EXPECT_TRUE(cost->bound);
}

TEST(LinkageTrials, LostRunsHaveNoCostAndNeitherHasTooCoarseAMethod) {
  EXPECT_FALSE(cost_of(Trials{{"simbody", "upright", "Rod Verlet", "lost at 2.7 s", 1, 1e-4, 1e-1},
                              {"simbody", "upright", "Rod CPodes", "ok", 1, 1e-2, 1e-1}},
                       1e-3)
                   .has_value());
}

TEST(LinkageTrials, RatiosSayWhoTakesHowLongAndHowManyTimesAsLong) {
  const Table table = ratios(Trials{{"simbody", "hanging", "Rod Verlet", "ok", 5, 1e-3, 1e-1},
                                    {"tandem", "hanging", "index3 1e-4", "ok", 5, 1e-3, 1e-3},
                                    {"tandem", "hanging", "penalty rk4", "ok", 5, 5e-4, 5e-4},
                                    {"simbody", "upright", "Rod Verlet", "failed at 1 s", 1, NAN, 1e-1}});
  const std::vector<std::vector<std::string>> expected = {
      {"hanging", "5", "0.1 s", "Rod Verlet", "0.001 s", "100", "<0.0005 s", ">200", "penalty rk4"},
      {"upright", "1", "-", "", "-", "-", "-", "-", ""}};
  EXPECT_EQ(table.rows(), expected);
}

}  // namespace
}  // namespace tandem::bench
