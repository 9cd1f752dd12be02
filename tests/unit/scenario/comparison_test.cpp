// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(Comparison, IsOfThePeakAndTheRmsInTheWindow) {
  Measure late;
  late.from = 1.0;
  const auto c = compare(table({0, 1, 2, 3}, {9, 1, 2, 3}), table({0, 1, 2, 3}, {8, 1, 1, 4}), {}, late);
  EXPECT_EQ(c.columns[0].absolute, 1.0);
  EXPECT_EQ(c.columns[0].peak, 4.0);
  EXPECT_EQ(c.columns[0].relative, 0.25);
  EXPECT_DOUBLE_EQ(c.columns[0].rms_of, std::sqrt(18.0 / 3.0));
  EXPECT_EQ(c.columns[0].end, 1.0);
}

TEST(Comparison, LeavesOutTimesWithoutStraightLinesThatOneHasNoRowAt) {
  Measure rows;
  rows.lines = false;
  const TimeTable fine = table({0, 0.4, 0.8, 1.2, 1.6, 2.0}, {0, 4, 8, 12, 16, 20}),
                  coarse = table({0, 1, 2}, {0, 99, 21});
  const auto c = compare(fine, coarse, {}, rows);
  EXPECT_EQ(c.columns[0].compared, 2U);
  EXPECT_EQ(c.columns[0].absolute, 1.0);
  EXPECT_TRUE(c.linear.empty());
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"x has no time"}, [&] {
    compare(table({0.3, 0.7, 1.3}, {1, 1, 1}), table({0.2, 0.9, 1.4}, {1, 1, 1}), {}, rows);
  }));
}

/// f and f' at n + 1 times over [0, 1].
TimeTable sampled(int n, double (*f)(double), double (*derivative)(double)) {
  TimeTable to{"file", {}, {"x", "der(x)"}, {{}, {}}};
  for (int k = 0; k <= n; ++k) {
    const double t = static_cast<double>(k) / n;
    to.times.push_back(t);
    to.columns[0].push_back(f(t));
    to.columns[1].push_back(derivative(t));
  }
  return to;
}

double sine(double t) { return std::sin(3.0 * t); }
double rate(double t) { return 3.0 * std::cos(3.0 * t); }

TEST(Comparison, InterpolatesByHermitePolynomialsWhereThereAreDerivatives) {
  // A has one interval more than B's n, so that no time inside is in both. The error of the cubic is of
  // order 4.
  const auto error = [](int n) {
    const auto c = compare(sampled(n + 1, sine, rate), sampled(n, sine, rate));
    EXPECT_EQ(c.columns.size(), 1U);
    EXPECT_TRUE(c.linear.empty());
    return c.columns[0].rms;
  };
  EXPECT_NEAR(std::log2(error(20) / error(40)), 4.0, 0.2);
}

TEST(Comparison, TellsWhatIsInterpolatedByStraightLines) {
  TimeTable finer = sampled(21, sine, rate);
  finer.names.back() = "other";
  const auto c = compare(finer, sampled(20, sine, rate));
  EXPECT_EQ(c.linear, std::vector<std::string>{"x"});
  EXPECT_NE(text(c).find("interpolated linearly"), std::string::npos);
}

TEST(Comparison, MeasuresTheRms) {
  const auto c = compare(table({0, 1, 2, 3}, {1, 2, 3, 5}), table({0, 1, 2, 3}, {1, 2, 3, 4}));
  EXPECT_DOUBLE_EQ(c.columns[0].rms, 0.5);
  EXPECT_DOUBLE_EQ(c.columns[0].relative_rms, std::sqrt(1.0 / 30.0));
  EXPECT_EQ(beyond(c, 0.19, Norm::rms), "");
  EXPECT_NE(beyond(c, 0.18, Norm::rms).find("x differs by 0.5 in rms"), std::string::npos);
}

TEST(Comparison, TakesTheTimesOfAWindow) {
  const TimeTable a = table({0, 1, 2, 3}, {9, 2, 3, 9}), b = table({0, 1, 2, 3}, {1, 2, 3, 4});
  const auto c = compare(a, b, {}, {.from = 1.0, .to = 2.0});
  EXPECT_EQ(c.times, 2U);
  EXPECT_EQ(c.columns[0].absolute, 0.0);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"no time is in both", "from 4 to 5 s count"},
                      [&] { compare(a, b, {}, {.from = 4.0, .to = 5.0}); }));
}

TEST(Comparison, FindsByHowMuchOneIsLater) {
  const auto later = [](double t) { return sine(t - 0.03); };
  const auto later_rate = [](double t) { return rate(t - 0.03); };
  const auto a = sampled(200, later, later_rate), b = sampled(100, sine, rate);
  EXPECT_NEAR(compare(a, b, {}, {.shift = 0.1}).shift, 0.03, 1e-6);
  EXPECT_NEAR(compare(b, a, {}, {.shift = 0.1}).shift, -0.03, 1e-6);
  EXPECT_LT(compare(a, b, {}, {.shift = 0.1}).columns[0].absolute, 1e-5);
  EXPECT_NEAR(compare(a, b, {}, {.shift = 0.02}).shift, 0.02, 1e-6);
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
