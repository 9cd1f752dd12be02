// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Held outputs, and what a sampled reader gets.
#include <gtest/gtest.h>

#include "link_bench.hpp"

namespace tandem {
namespace {

using test::LinkBench;

TEST(HeldLink, ASampleHoldsFromItsTimeToTheNext) {
  LinkBench bench("held");
  bench.give(0.0, 1.0);
  EXPECT_EQ(bench.read(0.0, 0.5).value(1e6), 1.0);
  bench.give(1.0, 2.0);
  bench.give(3.0, 4.0);
  const Signal whole = bench.read(0.5, 4.0);
  EXPECT_EQ(whole.segments().size(), 3U);
  EXPECT_EQ(whole.value(0.5), 1.0);
  EXPECT_EQ(whole.value(1.0), 1.0) << "who comes from before reads the value before";
  EXPECT_EQ(whole.value(1.0001), 2.0);
  EXPECT_EQ(whole.value(9.0), 4.0);
}

TEST(HeldLink, WhoStandsAtABreakReadsTheNewValueAlone) {
  LinkBench bench("held", 0.25);
  bench.give(0.0, 1.0);
  bench.give(0.1, 2.0);
  bench.give(0.2, 3.0);
  for (const double beside : {0.0, 1e-16, -1e-16}) {
    const double t = 0.1 + 0.25 + beside;
    EXPECT_EQ(bench.read(t, 1.0).value(t), 2.0);
    EXPECT_EQ(bench.read(t, 1.0).segments().size(), 2U);
  }
  EXPECT_EQ(bench.link().next_break(0.35), 0.2 + 0.25);
  EXPECT_EQ(bench.link().next_break(0.2 + 0.25), Member::never);
}

TEST(HeldLink, TheSecondOfTwoSamplesAtOneTimeHolds) {
  LinkBench bench("held");
  bench.give(0.0, 1.0);
  bench.give(0.0, 2.0, 0.0, 0.0, 0.0, true);
  EXPECT_EQ(bench.read(0.0, 1.0).value(0.0), 2.0);
}

TEST(HeldLink, ItsMeanIsWeightedByTime) {
  LinkBench bench("mean", 0.0, {0, 0, 1.0, 0.0, true}, {1, 1, 2.0, 1.0, true});
  for (const auto& [t, y] : {std::pair{0.0, 1.0}, {1.0, 5.0}, {1.25, 3.0}, {9.0, 100.0}}) bench.give(t, y, y);
  EXPECT_DOUBLE_EQ(bench.read(0.5, 2.0).value(1.0), (0.5 * 1.0 + 0.25 * 5.0 + 0.75 * 3.0) / 1.5);
  EXPECT_DOUBLE_EQ(bench.read(0.5, 2.0, 1).value(1.0),
                   2.0 * (0.5 * 1.0 + 0.25 * 5.0 + 0.75 * 3.0) / 1.5 + 1.0);
  EXPECT_DOUBLE_EQ(bench.read(1.5, 2.5).value(2.0), 3.0);
  EXPECT_DOUBLE_EQ(bench.read(1.0, 1.25).value(1.0), 5.0);
}

TEST(HeldLink, AValueThatIsGivenAnewIsReadAnew) {
  for (const char* how : {"held", "mean"}) {
    LinkBench bench(how, 0.0, {0, 0, 1.0, 0.0, true});
    bench.give(0.0, 1.0);
    bench.give(1.0, 2.0);
    bench.history().newest_values()[0] = 7.0;
    bench.link().remake(bench.history().row(1));
    EXPECT_EQ(bench.read(1.0, 2.0).value(1.5), 7.0) << how;
  }
}

double at_instant(LinkBench& bench, double last, double t) {
  double u[2] = {};
  bench.link().sample({last, t}, u);
  return u[0];
}

TEST(HeldLink, ASampledReaderGetsWhatIsNewAtItsInstant) {
  LinkBench bench("held");
  bench.link().read_at_instants(true, false);
  bench.give(0.0, 1.0);
  bench.give(0.1, 2.0);
  bench.give(0.2, 3.0);
  EXPECT_EQ(at_instant(bench, 0.0, 0.05), 1.0);
  EXPECT_EQ(at_instant(bench, 0.05, 0.1 - 1e-16), 2.0) << "instants within the tolerance are one";
  EXPECT_EQ(at_instant(bench, 0.1, 0.5), 3.0);
}

TEST(HeldLink, WithAMemoryItGetsTheValueJustBefore) {
  LinkBench bench("held");
  bench.link().read_at_instants(true, true);
  bench.give(0.0, 1.0);
  bench.give(0.1, 2.0);
  EXPECT_EQ(at_instant(bench, 0.0, 0.1), 1.0);
  EXPECT_EQ(at_instant(bench, 0.1, 0.1001), 2.0);
}

TEST(SampledReader, SeesNothingAfterItsInstantOfWhoDependsOnIt) {
  for (const bool within : {true, false}) {
    LinkBench bench("lagrange1");
    bench.link().read_at_instants(within, false);
    for (const double t : {0.0, 1.0, 2.0}) bench.give(t, t < 1.5 ? t : 8.0);
    EXPECT_DOUBLE_EQ(at_instant(bench, 0.0, 1.0), 1.0);
    EXPECT_DOUBLE_EQ(at_instant(bench, 1.0, 1.5), within ? 1.5 : 4.5);
  }
}

TEST(SampledReader, GetsTheValueBeforeAJumpAtItsInstant) {
  for (const bool within : {true, false}) {
    LinkBench bench("lagrange1");
    bench.link().read_at_instants(within, false);
    bench.give(0.0, 1.0);
    bench.give(1.0, 2.0);
    bench.give(1.0, 7.0, 0.0, 0.0, 0.0, true);
    EXPECT_DOUBLE_EQ(at_instant(bench, 0.0, 1.0), 2.0);
    EXPECT_DOUBLE_EQ(at_instant(bench, 1.0, 1.25), 7.0);
  }
}

TEST(PassedOver, ASampleNearerThanHalfAnOwnStepToTheNextNodeIsNone) {
  for (const double gap : {1e-14, 1e-9, 1e-4, 0.04}) {
    LinkBench bench("lagrange2");
    bench.link().pass_over(0.05);
    bench.link().attach(bench.history(), TimeTolerance());
    const auto cube = [](double t) { return t * t; };
    for (const double t : {0.0, 0.1, 0.2}) bench.give(t, cube(t));
    bench.give(0.2 + gap, cube(0.2 + gap) + 1e-12);
    EXPECT_NEAR(bench.read(0.2 + gap, 1.0).value(0.4), 0.16, 2e-10) << gap;
  }
}

}  // namespace
}  // namespace tandem
