// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/two_mass_best.hpp"

#include <gtest/gtest.h>

namespace tandem::charts {
namespace {

const Scheme a{"slowest-first", "lagrange3", "lagrange3"}, b{"slowest-first", "lagrange0", "lagrange0"},
    c{"staggered", "matched_hold", "matched_hold"};

Result result(const Scheme& scheme, double ratio, double error, double amplitude_error = 0.0) {
  Result r;
  r.scheme = scheme;
  r.frequency_ratio = ratio;
  r.position_error = error;
  r.amplitude_error = amplitude_error;
  return r;
}

bool any(const Scheme&) { return true; }

TEST(TwoMassBest, OneSchemeStandsForARangeWhereItIsNearlyTheBest) {
  // At ratio 2 b is better, but not twice; at 3 it is; at 1 both are small.
  const auto ranges = best_ranges({result(a, 1, 0.002), result(b, 1, 0.009), result(a, 2, 0.03),
                                   result(b, 2, 0.02), result(a, 3, 0.07), result(b, 3, 0.03)},
                                  [](const Scheme& s) { return !(s == c); });
  ASSERT_EQ(ranges.size(), 1U);  // b reaches further than a
  EXPECT_EQ(ranges[0].scheme, b);
  EXPECT_EQ(ranges[0].first_ratio, 1.0);
  EXPECT_EQ(ranges[0].last_ratio, 3.0);
  EXPECT_EQ(ranges[0].smallest_error, 0.009);
  EXPECT_EQ(ranges[0].largest_error, 0.03);
}

TEST(TwoMassBest, OfSchemesThatReachAsFarTheMoreAccurateIsTaken) {
  const auto ranges = best_ranges({result(a, 1, 0.03), result(b, 1, 0.02)}, any);
  ASSERT_EQ(ranges.size(), 1U);
  EXPECT_EQ(ranges[0].scheme, b);
}

TEST(TwoMassBest, RangesFollowEachOtherWhateverTheOrderOfTheRows) {
  const auto ranges =
      best_ranges({result(b, 50, 0.08), result(a, 50, 0.3), result(a, 3, 0.002), result(b, 3, 0.05)}, any);
  ASSERT_EQ(ranges.size(), 2U);
  EXPECT_EQ(ranges[0].scheme, a);
  EXPECT_EQ(ranges[1].scheme, b);
}

TEST(TwoMassBest, NoneIsBestAboveTheLimit) {
  Result failed = result(a, 90, 0.001);
  failed.failed = true;
  const auto ranges = best_ranges({result(a, 80, 0.101), failed, result(a, 99.5, 0.05, -1.0)}, any);
  ASSERT_EQ(ranges.size(), 1U);
  EXPECT_FALSE(ranges[0].scheme.has_value());
  EXPECT_EQ(ranges[0].first_ratio, 80.0);
  EXPECT_EQ(ranges[0].last_ratio, 99.5);
}

TEST(TwoMassBest, ADampedFastModeIsNotAnAccurateRun) {
  const std::vector<Result> results = {result(a, 60, 0.01, -0.99), result(b, 60, 0.09)};
  ASSERT_NE(best_at(results, 60.0), nullptr);
  EXPECT_EQ(best_at(results, 60.0)->scheme, b);
  EXPECT_EQ(best_at(results, 61.0), nullptr);
}

TEST(TwoMassBest, TheTableReadsAsItShould) {
  EXPECT_EQ(
      table_of({{1.5, 25.0, a, 0.00123, 0.0312}, {30.0, 30.0, b, 0.05, 0.05}, {55.0, 1000.0, std::nullopt}}),
      "  frequency ratio  best scheme                              error\n"
      "  1.5 to 25        slowest-first, lagrange3                 0.12 to 3.1 %\n"
      "  30               slowest-first, lagrange0                 5 %\n"
      "  55 to 1000       none\n");
}

TEST(TwoMassBest, TheShortTableAlsoTellsWhatIsBestWithoutMatchedHold) {
  const std::string text = short_table({result(a, 30, 0.04), result(c, 30, 0.01)});
  const auto second = text.find("Without matched hold");
  EXPECT_LT(text.find("staggered, matched_hold"), second);
  EXPECT_GT(text.find("slowest-first, lagrange3"), second);
}

}  // namespace
}  // namespace tandem::charts
