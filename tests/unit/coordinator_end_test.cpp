// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "refusal.hpp"
#include "run_bench.hpp"
#include "scripted.hpp"
#include "word.hpp"

namespace tandem {
namespace {

using test::RunBench;
using test::Scripted;

Scripted listener(double own_step, bool lands) {
  SubsystemInfo info = test::listener(own_step).info();
  info.abilities.lands = lands;
  return {info, own_step, [](double, const auto&, double* y) { y[0] = 0.0; }};
}

/// "fast" (0.1 s) and "slow" (0.25 s).
class End : public testing::TestWithParam<const char*> {
 protected:
  const test::Recording& run(bool lands, double t_stop, double t_start = 0.0) {
    fast = listener(0.1, lands);
    slow = listener(0.25, lands);
    bench = {};
    const std::string how = std::string(GetParam()) == "staggered" ? "matched_hold" : "lagrange1";
    bench.add("fast", fast).add("slow", slow).schedule(GetParam());
    bench.connect("fast.y", "slow.u", how).connect("slow.y", "fast.u", how);
    return bench.run(t_stop, t_start);
  }
  double end(int who) const { return bench.coordinator->time(who); }

  Scripted fast = listener(0.1, false), slow = listener(0.25, false);
  RunBench bench;
};
INSTANTIATE_TEST_SUITE_P(Schedules, End,
                         testing::Values("slowest-first", "fastest-first", "parallel", "staggered"),
                         [](const auto& p) { return test::word(p.param); });

TEST_P(End, IsExactForWhoCanLand) {
  for (const double t_stop : {1.0, 1.03, 0.02, 10.0 / 3.0, 7.25}) {
    run(true, t_stop);
    EXPECT_EQ(end(0), t_stop);
    EXPECT_EQ(end(1), t_stop);
    EXPECT_EQ(bench.coordinator->notes().size(), t_stop < 0.1 ? 2U : 0U)
        << "one shortened step alone is told";
  }
}

TEST_P(End, IsTheLastOwnNodeForTheOthersAndIsTold) {
  run(false, 1.03);
  EXPECT_EQ(end(0), 1.0);
  EXPECT_EQ(end(1), 1.0);
  run(false, 1.45);
  EXPECT_EQ(end(0), 1.4000000000000001);  // 14 * 0.1
  EXPECT_EQ(end(1), 1.25);
  std::string notes;
  for (const std::string& note : bench.coordinator->notes()) notes += note + "\n";
  EXPECT_NE(notes.find("'fast' ended at t = 1.4"), std::string::npos) << notes;
  EXPECT_NE(notes.find("'slow' ended at t = 1.25"), std::string::npos) << notes;
  EXPECT_NE(notes.find("0.2"), std::string::npos) << notes;
}

TEST_P(End, OnANodeIsReachedAlthoughRoundingPutsItBesides) {
  run(false, 0.3);  // 3 * 0.1 is an ulp above 0.3
  EXPECT_EQ(end(0), 3 * 0.1);
  run(false, -0.7, -1.0);
  EXPECT_EQ(end(0), -1.0 + 3 * 0.1);
}

TEST_P(End, NobodyIsAskedForAnythingBeyondIt) {
  for (const bool lands : {false, true})
    for (const double t_stop : {1.03, 1.45, 2.0, 0.3}) {
      run(lands, t_stop);
      for (const Scripted* s : {&fast, &slow})
        for (const Scripted::Call& call : s->calls) {
          EXPECT_LE(call.limit, t_stop * (1.0 + 1e-15)) << "the end, within the tolerance";
          EXPECT_TRUE(lands || !call.land) << "who can't land is not asked to";
        }
    }
}

TEST_P(End, BeforeTheFirstNodeOfWhoCanNotLandIsRefused) {
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"'fast'", "own step of 0.1 s", "span, 0.05 s"},
                            [&] { run(false, 0.05); }));
}

TEST_P(End, SaysNoAgainWhenAskedAgain) {
  run(false, 1.03);
  const std::size_t notes = bench.coordinator->notes().size();
  EXPECT_FALSE(bench.coordinator->round());
  EXPECT_EQ(bench.coordinator->notes().size(), notes);
}

/// Ends the run when a subsystem has reached t = 1.
class StopAtOne final : public Observer {
 public:
  bool samples(int, const History& h, std::int64_t, std::int64_t last) override { return h.time(last) < 1.0; }
};

TEST_P(End, ComesEarlyIfTheObserverSaysSo) {
  run(false, 0.5);
  std::vector<Subsystem*> both = {&fast, &slow};
  Coordinator coordinator(bench.topology, both, bench.coordination, {0.0, 100.0});
  StopAtOne observer;
  coordinator.observe(&observer);
  coordinator.run();
  EXPECT_LE(coordinator.time(0), 1.3);
  EXPECT_LE(coordinator.time(1), 1.3);
  EXPECT_FALSE(coordinator.round());
}

TEST(OwnSteps, MayBeTinyOrHuge) {
  for (const double step : {1e-9, 1e6, 1.0 / std::numbers::sqrt2}) {
    Scripted fast = listener(step, true), slow = listener(7.3 * step, true);
    RunBench bench;
    bench.add("fast", fast).add("slow", slow).connect("fast.y", "slow.u").connect("slow.y", "fast.u");
    bench.run(1000.0 * step);
    EXPECT_EQ(bench.coordinator->effort(0).steps, 1000);
    EXPECT_EQ(bench.coordinator->effort(1).steps, 137);
    EXPECT_EQ(bench.coordinator->time(0), 1000.0 * step);
    EXPECT_EQ(bench.coordinator->time(1), 1000.0 * step);
  }
}

TEST(Effort, CountsCallsAndOwnStepsAndSecondsOnlyWithProfile) {
  for (const bool profile : {false, true}) {
    Scripted fast = listener(0.1, false), slow = listener(0.3, false);
    RunBench bench;
    bench.add("fast", fast).add("slow", slow).connect("fast.y", "slow.u").connect("slow.y", "fast.u");
    bench.coordination.profile = profile;
    bench.run(300.0);
    EXPECT_EQ(bench.coordinator->effort(0).steps, 3000);
    EXPECT_EQ(bench.coordinator->effort(1).steps, 1000);
    EXPECT_EQ(bench.coordinator->effort(0).exchanges, 1000);
    EXPECT_EQ(bench.coordinator->effort(0).exchanges, static_cast<std::int64_t>(fast.calls.size()));
    EXPECT_EQ(bench.coordinator->effort(1).exchanges, 1000);
    for (const int who : {0, 1}) EXPECT_EQ(bench.coordinator->effort(who).seconds > 0.0, profile);
    EXPECT_EQ(bench.coordinator->own_step(1), 0.3);
  }
}

TEST(Room, ForMoreStepsThanACallMayTakeIsMadeInSeveralCalls) {
  Scripted fast = listener(1e-3, false), slow = listener(20.0, false);  // 20 000 fast steps to a slow one
  RunBench bench;
  bench.add("fast", fast).add("slow", slow).connect("fast.y", "slow.u").connect("slow.y", "fast.u");
  bench.run(40.0);
  EXPECT_EQ(bench.coordinator->effort(0).steps, 40'000);
  EXPECT_EQ(bench.recording.rows(0).size(), 40'001U);
  EXPECT_LE(bench.coordinator->exchange().history(0).capacity(), 8192);
}

}  // namespace
}  // namespace tandem
