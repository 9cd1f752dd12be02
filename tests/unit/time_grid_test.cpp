// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/time_grid.hpp"

#include <gtest/gtest.h>

#include <random>

#include "refusal.hpp"

namespace tandem {
namespace {

using test::refuses;
constexpr double grid_eps = std::numeric_limits<double>::epsilon();
constexpr std::int64_t ten_million = 10'000'000;

TEST(TimeGrid, TenMillionStepsOfATenthEndAtAMillion) {
  TimeGrid grid(0.0, 0.1);
  double accumulated = 0.0;
  for (std::int64_t k = 0; k < ten_million; ++k) {
    grid.step();
    accumulated += 0.1;
  }
  EXPECT_EQ(grid.time(), 1e6);
  EXPECT_GT(std::abs(accumulated - 1e6), 1e-5)
      << "or this test would not tell multiplied from accumulated time";
}

TEST(TimeGrid, NodesAreMultipliedForStepsOfAnySizeAndStart) {
  for (const double h : {0.1 / std::sqrt(2.0), 1e-9, 1e6, 1.0 / 3.0, 30.7e-2})
    for (const double t_start : {0.0, -2.5, 1e3}) {
      TimeGrid grid(t_start, h);
      for (int k = 1; k <= 100'000; ++k) {
        const double before = grid.time();
        grid.step();
        ASSERT_EQ(grid.time(), t_start + k * h);
        ASSERT_GT(grid.time(), before);
        ASSERT_EQ(grid.next(), t_start + (k + 1) * h);
      }
    }
}

/// n h2 = k h1 with h1 a decimal and h2 = h1 m / q. The bounds are derived in time_grid.hpp: 2 eps |t|
/// from t_start = 0, else 5 eps max(|t|, |t_start|) (3.998 were found in 6e7 random cases with t near
/// -t_start).
void meet_at_common_nodes(double t_start, double largest) {
  std::mt19937_64 random(1);
  const TimeTolerance tolerance(t_start);
  const auto pick = [&random](std::int64_t from, std::int64_t to) {
    return std::uniform_int_distribution(from, to)(random);
  };
  for (int i = 0; i < 200'000; ++i) {
    const auto a = static_cast<double>(pick(1, 999)), scale = std::pow(10.0, static_cast<double>(pick(0, 5)));
    const std::int64_t m = pick(1, 400), q = pick(1, 20), round = pick(1, ten_million / std::max(m, q));
    const double h1 = a / scale, h2 = a * static_cast<double>(m) / static_cast<double>(q) / scale;
    std::int64_t rounds = round;
    if (t_start < 0.0 && i % 2)  // near t = 0, where max |t| alone would be too narrow
      rounds = std::clamp<std::int64_t>(std::llround(-t_start / (h2 * static_cast<double>(q))), 1, round);
    const double t1 = t_start + static_cast<double>(rounds * m) * h1,
                 t2 = t_start + static_cast<double>(rounds * q) * h2;
    ASSERT_LE(std::abs(t1 - t2),
              largest * grid_eps * std::max({std::abs(t1), std::abs(t2), std::abs(t_start)}));
    ASSERT_FALSE(tolerance.before(t1, t2) || tolerance.before(t2, t1)) << h1 << " " << h2 << " " << rounds;
  }
}

TEST(TimeTolerance, GridsThatMeetByDefinitionMeetFromZero) { meet_at_common_nodes(0.0, 2.0); }
TEST(TimeTolerance, GridsThatMeetByDefinitionMeetFromAnyStart) {
  for (const double t_start : {-0.1, -1.0, -37.3, 0.7, 1e4, -1e5}) meet_at_common_nodes(t_start, 5.0);
}

TEST(TimeTolerance, TellsNeighbouringTimesApart) {
  const TimeTolerance tolerance(0.0);
  EXPECT_TRUE(tolerance.before(1e6, 1e6 + 2e-9));  // the width is 6 grid_eps 1e6 = 1.4e-9
  EXPECT_TRUE(tolerance.before(0.0, 1e-300));
  EXPECT_FALSE(tolerance.before(1.0, 1.0));
  EXPECT_FALSE(tolerance.before(1.0 + grid_eps, 1.0));
  EXPECT_FALSE(tolerance.before(1.0, 1.0 + grid_eps));
}

TEST(TimeGrid, ACutLeavesTheGridAsItWas) {
  TimeGrid grid(1.0, 0.25);
  grid.step();
  EXPECT_TRUE(grid.cuts(1.4));
  EXPECT_FALSE(grid.fits(1.4));
  grid.cut(1.4);
  EXPECT_EQ(grid.time(), 1.4);
  EXPECT_EQ(grid.next(), 1.5);
  EXPECT_EQ(grid.length(), 1.5 - 1.4);
  grid.cut(1.45);
  EXPECT_EQ(grid.length(), 1.5 - 1.45);
  grid.step();
  EXPECT_EQ(grid.time(), 1.5);
  EXPECT_EQ(grid.length(), 0.25);
  EXPECT_EQ(grid.next(), 1.75);
}

TEST(TimeGrid, ALimitOnANodeFitsAndDoesNotCut) {
  TimeGrid grid(0.0, 0.1);
  for (int k = 0; k < 2; ++k) grid.step();
  EXPECT_TRUE(grid.fits(0.3)) << "3 * 0.1 is one ulp above 0.3";
  EXPECT_FALSE(grid.cuts(0.3));
  EXPECT_FALSE(grid.cuts(grid.time())) << "nothing to cut where it stands";
  EXPECT_FALSE(grid.cuts(0.1)) << "a limit behind it";
}

TEST(TimeGrid, RefusesStepsThatAreNone) {
  const auto make = [](double t_start, double h) { return [=] { TimeGrid(t_start, h); }; };
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"own step -0.5"}, make(0.0, -0.5)));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"own step 0", "above 0"}, make(0.0, 0.0)));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"own step nan"}, make(0.0, std::nan(""))));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"own step inf"}, make(0.0, INFINITY)));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"t_start inf"}, make(INFINITY, 1.0)));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"1e-20", "t_start 3"}, make(3.0, 1e-20)));
}

}  // namespace
}  // namespace tandem
