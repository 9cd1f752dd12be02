// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/time_series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "refusal.hpp"

namespace tandem {
namespace {

using Between = TimeSeries::Between;
using Beyond = TimeSeries::Beyond;
using Numbers = std::vector<double>;

Numbers list(std::span<const double> all) { return {all.begin(), all.end()}; }

TEST(TimeSeries, LinesJoinPointsAndATimeTwiceIsAJump) {
  const TimeSeries s("data", Numbers{0, 1, 1, 3, 4}, Numbers{0, 2, 5, 1, -1}, {});
  EXPECT_EQ(s.value(0.5), 1.0);
  EXPECT_EQ(s.value(std::nextafter(1.0, 0.0)), 2.0 * std::nextafter(1.0, 0.0));
  EXPECT_EQ(s.value(1.0), 5.0);
  EXPECT_EQ(s.value(2.0), 3.0);
  EXPECT_EQ(list(s.jumps()), Numbers{1});
  EXPECT_TRUE(s.kinks().empty()) << "from 1 on it falls by 2 a second";
  EXPECT_EQ(s.begin(), 0.0);
  EXPECT_EQ(s.end(), 4.0);
}

TEST(TimeSeries, HeldValuesJumpWhereTheyChange) {
  const TimeSeries s("data", Numbers{0, 1, 2, 2, 3}, Numbers{4, 4, 4, 6, 7}, {Between::hold, Beyond::hold});
  for (const auto& [t, value] :
       {std::pair{-1.0, 4.0}, {0.5, 4.0}, {1.9, 4.0}, {2.0, 6.0}, {2.9, 6.0}, {3.0, 7.0}, {9.0, 7.0}})
    EXPECT_EQ(s.value(t), value) << t;
  EXPECT_EQ(list(s.jumps()), (Numbers{2, 3}));
  EXPECT_TRUE(s.kinks().empty());
}

TEST(TimeSeries, HeldFirstAndLastValuesBendALine) {
  const TimeSeries s("data", Numbers{1, 2, 3}, Numbers{4, 6, 6}, {Between::linear, Beyond::hold});
  EXPECT_EQ(s.value(0.0), 4.0);
  EXPECT_EQ(s.value(1.5), 5.0);
  EXPECT_EQ(s.value(7.0), 6.0);
  EXPECT_EQ(list(s.kinks()), (Numbers{1, 2}));
  EXPECT_TRUE(std::isinf(s.begin()) && std::isinf(s.end()));
}

TEST(TimeSeries, JumpsAtItsEndsAreThere) {
  const Numbers t{0, 0, 1, 1}, y{1, 2, 3, 4};
  const TimeSeries held("data", t, y, {Between::linear, Beyond::hold}), refused("data", t, y, {});
  EXPECT_EQ(held.value(-1.0), 1.0);
  EXPECT_EQ(list(held.jumps()), (Numbers{0, 1}));
  EXPECT_EQ(list(refused.jumps()), Numbers{1});
  for (const TimeSeries& s : {held, refused}) {
    EXPECT_EQ(s.value(0.0), 2.0);
    EXPECT_EQ(s.value(1.0), 4.0);
  }
}

/// Half the interval: a sixteenth of the error, as the sine has no second derivative at its ends.
TEST(TimeSeries, SplineIsOfOrderFour) {
  double before = 0.0;
  for (const int n : {20, 40}) {
    Numbers t, y;
    for (int k = 0; k <= n; ++k) t.push_back(std::numbers::pi * k / n), y.push_back(std::sin(t.back()));
    const TimeSeries s("data", t, y, {Between::spline});
    double largest = 0.0;
    for (int k = 0; k < 1000; ++k)
      largest = std::max(largest, std::abs(s.value(0.003 * k) - std::sin(0.003 * k)));
    if (before > 0.0) {
      EXPECT_NEAR(std::log2(before / largest), 4.0, 0.2);
    }
    before = largest;
    EXPECT_TRUE(s.kinks().empty() && s.jumps().empty());
    for (std::size_t k = 1; k < s.pieces().size(); ++k) {
      const Segment &a = s.pieces()[k - 1], &b = s.pieces()[k];
      const Signal left(&a, 1, 3), right(&b, 1, 3);
      EXPECT_NEAR(left.value(b.origin), right.value(b.origin), 1e-15);
      EXPECT_NEAR(left.derivative(b.origin), right.derivative(b.origin), 1e-14);
      EXPECT_NEAR(left.second_derivative(b.origin), right.second_derivative(b.origin), 1e-12);
    }
  }
}

TEST(TimeSeries, BeyondItNothingIsKnownUnlessItIsHeld) {
  const TimeSeries s("column 'F'", Numbers{1, 2}, Numbers{3, 4}, {});
  s.require(1.0);
  s.require(2.0 + 1e-15);
  EXPECT_TRUE(test::refuses(
      ErrorCode::numerical,
      {"column 'F' is asked for at t = 2.5 s; it has data from 1 to 2 s, and beyond = \"refuse\" says that "
       "nothing is known there"},
      [&] { s.require(2.5); }));
  TimeSeries("data", Numbers{1, 2}, Numbers{3, 4}, {Between::linear, Beyond::hold}).require(1e9);
}

TEST(TimeSeries, RefusesPointsThatAreNone) {
  const auto refused = [](const std::string& sentence, const Numbers& t, const Numbers& y,
                          Between between = Between::linear) {
    return test::refuses(ErrorCode::invalid_argument, {sentence},
                         [&] { TimeSeries("data", t, y, {between}); });
  };
  EXPECT_TRUE(refused("data has 1 points; allowed are 2 or more", {1}, {1}));
  EXPECT_TRUE(refused("data has 2 times and 1 values; allowed are as many", {1, 2}, {1}));
  EXPECT_TRUE(
      refused("data has the time 0.5 s after 1 s; allowed are times that never fall", {1, 0.5}, {1, 1}));
  EXPECT_TRUE(refused("data has the time 1 s three times; allowed is once, or twice for a jump", {0, 1, 1, 1},
                      {0, 0, 0, 0}));
  EXPECT_TRUE(refused("the time 1 s twice, which is a jump; allowed for a spline are times that rise",
                      {0, 1, 1, 2}, {0, 0, 0, 0}, Between::spline));
  EXPECT_TRUE(refused("data holds nan; allowed are finite numbers", {0, 1}, {0, NAN}));
  EXPECT_TRUE(refused("data has one time; allowed are two or more", {2, 2}, {0, 1}));
}

}  // namespace
}  // namespace tandem
