// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "scenario/comparison.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "refusal.hpp"

namespace tandem::scenario {
namespace {

using test::refuses;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

TimeTable table(std::vector<double> times, std::vector<double> x, const std::string& name = "x") {
  return {"file", std::move(times), {name}, {std::move(x)}};
}

TEST(Comparison, EqualResultsDoNotDiffer) {
  const TimeTable a = table({0, 1, 2}, {1, 2, 3});
  const auto c = compare(a, a);
  EXPECT_EQ(c.columns[0].absolute, 0.0);
  EXPECT_EQ(c.times, 3U);
  EXPECT_EQ(c.interpolated, 0U);
  EXPECT_EQ(beyond(c, 0.0), "");
}

TEST(Comparison, TellsWhereAndByHowMuchTheyDifferMost) {
  const auto c = compare(table({0, 1, 2}, {1, 2.5, 3}), table({0, 1, 2}, {1, 2, -4}));
  EXPECT_EQ(c.columns[0].time, 2.0);
  EXPECT_EQ(c.columns[0].absolute, 7.0);
  EXPECT_EQ(c.columns[0].relative, 7.0 / 4.0);
  EXPECT_NE(beyond(c, 1.7).find("x differs by 7"), std::string::npos);
  EXPECT_EQ(beyond(c, 1.75), "");
}

TEST(Comparison, InterpolatesTheFinerOneWhereItHasNoRow) {
  const auto c = compare(table({0, 0.4, 0.8, 1.2}, {0, 0.4, 0.8, 1.2}), table({0, 1}, {0, 1}));
  EXPECT_EQ(c.times, 2U);
  EXPECT_EQ(c.interpolated, 1U);
  EXPECT_NEAR(c.columns[0].absolute, 0.0, 1e-15);
}

TEST(Comparison, TakesTheTimesThatBothCover) {
  EXPECT_EQ(compare(table({0, 1, 2}, {0, 1, 2}), table({1, 2, 3}, {1, 2, 3})).times, 2U);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"no time is in both", "0 to 1 s", "2 to 3 s"}, [] {
    compare(table({0, 1}, {0, 1}), table({2, 3}, {0, 1}));
  }));
}

TEST(Comparison, LeavesEmptyCellsOut) {
  const auto c = compare(table({0, 1, 2}, {1, none, 3}), table({0, 1, 2}, {1, 2, none}));
  EXPECT_EQ(c.columns[0].compared, 1U);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"x", "no time at which both"}, [] {
    compare(table({0, 1}, {none, 1}), table({0, 1}, {1, none}));
  }));
}

TEST(Comparison, AJumpIsComparedBeforeAndAfter) {
  const TimeTable step = table({0, 1, 1, 2}, {0, 0, 5, 5});
  EXPECT_EQ(compare(step, step).columns[0].absolute, 0.0);
  EXPECT_EQ(compare(step, table({0, 1, 1, 2}, {0, 0, 4, 5})).columns[0].absolute, 1.0);
}

TEST(Comparison, NamesAColumnThatIsMissing) {
  const TimeTable a = table({0, 1}, {0, 1}, "fast.x1"), b = table({0, 1}, {0, 1}, "slow.x2");
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"no column is in both", "fast.x1", "slow.x2"},
                      [&] { compare(a, b); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'fast.x2'", "did you mean 'fast.x1'?"},
                      [&] { compare(a, a, {"fast.x2"}); }));
}

}  // namespace
}  // namespace tandem::scenario
