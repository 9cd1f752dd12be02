// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "link_bench.hpp"

namespace tandem {
namespace {

using test::LinkBench;

double square(double t) { return t * t; }

TEST(MeanLink, IsTheArithmeticMeanOfTheSamplesWithinTheReadersStepEndsIncluded) {
  LinkBench bench("mean");
  for (int k = 0; k <= 20; ++k) bench.give(0.1 * k, square(0.1 * k));
  const double after_third = std::nextafter(3 * 0.1, 1.0);
  for (const auto& [from, to] : {std::pair{0.0, 1.0},
                                 {0.3, 1.3},
                                 {0.55, 0.95},
                                 {0.3, 0.3000001},
                                 {0.0, 2.0},
                                 {0.2, 0.6},              // 6 * 0.1 is an ulp above 0.6
                                 {after_third, 0.65}}) {  // and 3 * 0.1 an ulp before
    double sum = 0.0;
    int count = 0;
    for (int k = 0; k <= 20; ++k)
      if (k * 0.1 > from - 1e-12 && k * 0.1 < to + 1e-12) sum += square(0.1 * k), ++count;
    const Signal signal = bench.read(from, to);
    for (const double t : {from, (from + to) / 2.0, to})
      EXPECT_NEAR(signal.value(t), sum / count, 1e-14)
          << from << " to " << to;  // 21 roundings of up to eps/2 * 4
    EXPECT_EQ(signal.segments().size(), 1U);
  }
}

TEST(MeanLink, IsThatOfTheLineThroughTheSamplesBesideTheStepIfNoneIsInside) {
  LinkBench bench("mean");
  for (const double t : {0.0, 1.0, 2.0, 4.0}) bench.give(t, 10.0 + t * t);
  EXPECT_NEAR(bench.read(1.2, 1.4).value(1.3), 11.0 + 0.3 * 3.0, 1e-14);
  EXPECT_NEAR(bench.read(2.5, 3.0).value(2.5), 14.0 + 0.375 * 12.0, 1e-14);
  EXPECT_EQ(bench.read(4.5, 4.6).value(4.5), 26.0) << "none comes after it: the newest";
}

TEST(MeanLink, OfALineThatEndsInAJumpTakesTheValueBeforeIt) {
  LinkBench bench("mean");
  bench.give(0.0, 1.0);
  bench.give(1.0, 2.0);
  bench.give(1.0, 6.0, 0.0, 0.0, 0.0, true);
  bench.give(2.0, 8.0);
  EXPECT_NEAR(bench.read(0.2, 0.4).value(0.3), 1.3, 1e-15);
  EXPECT_NEAR(bench.read(1.2, 1.4).value(1.3), 6.6, 1e-15);
}

TEST(MeanLink, LeavesOutWhatTheSourceGaveBeyondTheStep) {
  LinkBench bench("mean");
  bench.give(0.0, 1.0);
  bench.give(1.0, 2.0);
  bench.give(1.5, 1e9);
  EXPECT_EQ(bench.read(0.0, 1.0).value(0.5), 1.5);
}

TEST(MeanLink, CountsBothSamplesOfAJumpAtOneTime) {
  LinkBench bench("mean");
  bench.give(0.0, 1.0);
  bench.give(1.0, 2.0);
  bench.give(1.0, 6.0, 0.0, 0.0, 0.0, true);
  EXPECT_EQ(bench.read(0.0, 1.0).value(0.5), 3.0);
}

TEST(MatchedHoldLink, HoldsTheNewestSampleOverTheWholeCall) {
  LinkBench bench("matched_hold");
  for (const double t : {0.0, 1.0, 2.0}) {
    bench.give(t, 10.0 + t, -t);
    for (const double at :
         {0.0, 0.5, 1.0, 1.5, 2.0, 7.0}) {  // whether the reader is behind the newest sample or ahead
      EXPECT_EQ(bench.read(0.0, 3.0, 0).value(at), 10.0 + t);
      EXPECT_EQ(bench.read(0.0, 3.0, 1).value(at), -t);
      EXPECT_EQ(bench.read(0.0, 3.0, 0).derivative(at), 0.0);
    }
  }
}

TEST(HoldLinks, KeepWhatTheyNeedWhenTheSourceDropsRows) {
  for (const char* how : {"mean", "matched_hold"}) {
    LinkBench kept(how), moved(how);
    for (int k = 0; k < 30; ++k) kept.give(0.1 * k, k), moved.give(0.1 * k, k);
    moved.read(2.5, 2.8);
    moved.history().make_room(moved.link().oldest_needed(2.5), 60);
    moved.link().follow_room();
    EXPECT_GT(moved.history().oldest(), 20) << how;
    EXPECT_EQ(moved.read(2.5, 2.8).value(2.6), kept.read(2.5, 2.8).value(2.6)) << how;
    EXPECT_EQ(moved.read(2.55, 2.58).value(2.56), kept.read(2.55, 2.58).value(2.56)) << how;
  }
}

}  // namespace
}  // namespace tandem
