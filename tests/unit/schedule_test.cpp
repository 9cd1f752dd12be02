// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "refusal.hpp"
#include "schedule_bench.hpp"

namespace tandem {
namespace {

using test::ScheduleBench;
using test::Walker;
using Kind = Schedule::Kind;

/// Runs a schedule; `order` has the leader first, and H is the largest own step.
std::string turns(Kind kind, const std::vector<Walker>& walkers, std::vector<int> order, double t_stop,
                  double t_start = 0.0) {
  double h = 0.0;
  for (const Walker& w : walkers) h = std::max(h, w.own_step);
  return ScheduleBench(walkers, kind, std::move(order), {t_start, t_stop}, h,
                       test::all_read_all(walkers.size()))
      .run();
}

// The lists below are worked out by hand from the rules in docs: who is due, who has to go before, and up to
// where.

TEST(Schedule, SlowestFirstAtRatio3TakesOneTurnEach) {
  EXPECT_EQ(turns(Kind::slowest_first, {{'F', 1.0}, {'S', 3.0}}, {1, 0}, 9.0), "S3 F3 S6 F6 S9 F9");
}

TEST(Schedule, FastestFirstAtRatio3TakesOneTurnEach) {
  EXPECT_EQ(turns(Kind::fastest_first, {{'F', 1.0}, {'S', 3.0}}, {0, 1}, 9.0), "F3 S3 F6 S6 F9 S9");
}

TEST(Schedule, SlowestFirstAtRatioTwoAndAHalf) {
  EXPECT_EQ(turns(Kind::slowest_first, {{'F', 1.0}, {'S', 2.5}}, {1, 0}, 10.0),
            "S2.5 F2 S5 F5 S7.5 F7 S10 F10");
}

TEST(Schedule, FastestFirstAtRatioTwoAndAHalfGoesPastTheSlowSidesNode) {
  EXPECT_EQ(turns(Kind::fastest_first, {{'F', 1.0}, {'S', 2.5}}, {0, 1}, 10.0),
            "F2 F3 S2.5 F5 S5 F7 F8 S7.5 F10 S10");
}

std::string linked_turns(Kind kind, const std::vector<Walker>& walkers, std::vector<int> order, double t_stop,
                         const std::vector<Read>& reads) {
  return ScheduleBench(walkers, kind, std::move(order), {0.0, t_stop}, 1.0, reads).run();
}

TEST(Schedule, AHubsPartnersGoTogetherAndAsFarAsTheHub) {
  const std::vector<Walker> walkers = {{'S', 3.0}, {'A', 1.0}, {'B', 0.75}};
  const std::vector<Read> star = {{0, 1}, {0, 2}, {1, 0}, {2, 0}};
  EXPECT_EQ(linked_turns(Kind::slowest_first, walkers, {0, 1, 2}, 6.0, star), "S3 (A3 B3) S6 (A6 B6)");
  EXPECT_EQ(linked_turns(Kind::fastest_first, walkers, {2, 1, 0}, 6.0, star), "(A3 B3) S3 (A6 B6) S6");
}

TEST(Schedule, WhoReadsNobodyAndIsReadByNobodyGoesToTheEnd) {
  EXPECT_EQ(linked_turns(Kind::slowest_first, {{'A', 1.0}, {'B', 0.5}}, {0, 1}, 2.0, {}), "(A2 B2)");
}

TEST(Schedule, PairsThatAreNotLinkedHaveTurnsOfTheirOwnAndStayTogether) {
  const std::vector<Walker> walkers = {{'A', 4.0}, {'B', 1.0}, {'C', 1.5}, {'D', 0.5}};
  EXPECT_EQ(linked_turns(Kind::slowest_first, walkers, {0, 2, 1, 3}, 8.0, {{0, 1}, {1, 0}, {3, 2}}),
            "(A4 C1.5) (B4 D1.5) C3 D3 (A8 C4.5) (B8 D4.5) C6 D6 C7.5 D8");
}

TEST(Schedule, ALeaderThatIsNotReadByItsFollowersFollowerWaitsForNobodyElse) {
  // B leads C, A leads B; A and C are not linked, so C limits A in no way.
  EXPECT_EQ(linked_turns(Kind::slowest_first, {{'A', 1.5}, {'B', 1.0}, {'C', 0.8}}, {0, 1, 2}, 3.0,
                         {{1, 0}, {2, 1}}),
            "A1.5 B1 (A3 C0.8) B2 C1.6 B3 C2.4");
}

TEST(Schedule, OfThoseThatWaitInARingTheLeaderGoes) {
  // A stands at 2, B at 1.5, C at 0.9. C waits for B to pass 1.8, B for A to pass 3, and A for C, whose
  // node 1.8 lies before it.
  EXPECT_EQ(linked_turns(Kind::slowest_first, {{'A', 2.0}, {'B', 1.5}, {'C', 0.9}}, {0, 1, 2}, 4.0,
                         {{0, 1}, {1, 2}, {2, 0}}),
            "A2 B1.5 C0.9 A4 B3 C3.6");
}

TEST(Schedule, RolesMayBeSwappedByOrder) {
  EXPECT_EQ(turns(Kind::slowest_first, {{'F', 1.0}, {'S', 2.5}}, {0, 1}, 5.0), "F2 F3 S2.5 F5 S5");
}

TEST(Schedule, EqualStepsAlternate) {
  EXPECT_EQ(turns(Kind::slowest_first, {{'A', 1.0}, {'B', 1.0}}, {0, 1}, 3.0), "A1 B1 A2 B2 A3 B3");
}

TEST(Schedule, ThreeSubsystemsFollowOneAnother) {
  // Steps 4, 2, 1: C can go when B has passed its node, B when A has.
  EXPECT_EQ(turns(Kind::slowest_first, {{'A', 4.0}, {'B', 2.0}, {'C', 1.0}}, {0, 1, 2}, 8.0),
            "A4 B2 C2 B4 C4 A8 B6 C6 B8 C8");
  // Steps 1, 2, 4, leader first: C goes as far as the next nodes of B and A allow.
  EXPECT_EQ(turns(Kind::fastest_first, {{'A', 4.0}, {'B', 2.0}, {'C', 1.0}}, {2, 1, 0}, 8.0),
            "C2 B2 C4 B4 A4 C6 B6 C8 B8 A8");
}

TEST(Schedule, ALeaderOfALeaderGoesFirst) {
  // C (0.8) is due at 0.8, but B (1) has not passed it, and A (1.5) not B's node 1.
  EXPECT_EQ(turns(Kind::slowest_first, {{'A', 1.5}, {'B', 1.0}, {'C', 0.8}}, {0, 1, 2}, 3.0),
            "A1.5 B1 C0.8 A3 B2 C1.6 B3 C2.4");
}

TEST(Schedule, AReaderOfAMeanTakesOneStepAtATime) {
  EXPECT_EQ(turns(Kind::slowest_first, {{'F', 1.0, false, true}, {'S', 3.0}}, {1, 0}, 3.0), "S3 F1 F2 F3");
  EXPECT_EQ(turns(Kind::fastest_first, {{'F', 1.0}, {'S', 0.5, false, true}}, {0, 1}, 2.0),
            "F1 S0.5 S1 F2 S1.5 S2");
}

TEST(Schedule, ParallelAdvancesAllToTheNextCommunicationPoint) {
  EXPECT_EQ(turns(Kind::parallel, {{'F', 1.0}, {'S', 3.0}}, {0, 1}, 6.0), "(F3 S3) (F6 S6)");
  // T = 2.5, 5, ...: the fast side stands at 2 and goes on to 5.
  EXPECT_EQ(turns(Kind::parallel, {{'F', 1.0}, {'S', 2.5}}, {0, 1}, 10.0),
            "(F2 S2.5) (F5 S5) (F7 S7.5) (F10 S10)");
}

TEST(Schedule, ParallelWithACommunicationStepBelowTheOwnSteps) {
  // H = 1: the points without a node in the next interval are left out, and those who can't reach one wait.
  ScheduleBench bench({{'F', 1.5}, {'S', 2.5}}, Kind::parallel, {0, 1}, {0.0, 6.0}, 1.0, {});
  EXPECT_EQ(bench.run(), "F1.5 (F3 S2.5) (F4.5 S5) F6");
}

TEST(Schedule, ParallelWithALongCommunicationStepTakesManyStepsEach) {
  ScheduleBench bench({{'F', 1.0, true}, {'S', 2.0, true}}, Kind::parallel, {0, 1}, {0.0, 9.0}, 4.0, {});
  EXPECT_EQ(bench.run(), "(F4 S4) (F8 S8) (F9 S9)");
}

TEST(Schedule, StaggeredStepsTheSlowSideFromTheMiddleOfItsStep) {
  EXPECT_EQ(turns(Kind::staggered, {{'F', 1.0, true}, {'S', 4.0, true}}, {1, 0}, 8.0), "F2 S4 F6 S8 F8");
  EXPECT_EQ(turns(Kind::staggered, {{'F', 1.0, true}, {'S', 3.0, true}}, {1, 0}, 6.0), "F1.5 S3 F4.5 S6 F6");
  EXPECT_EQ(turns(Kind::staggered, {{'F', 1.0, true}, {'S', 2.5, true}}, {1, 0}, 6.0),
            "F1.25 S2.5 F3.75 S5 F5.5 S6 F6")
      << "its last step is cut, and the middle is that of what is left";
}

TEST(Schedule, StaggeredWithoutLandingGoesToTheFirstNodeAtOrPastTheMiddle) {
  EXPECT_EQ(turns(Kind::staggered, {{'F', 1.0}, {'S', 3.0}}, {1, 0}, 6.0), "F1 F2 S3 F4 F5 S6 F6");
  EXPECT_EQ(turns(Kind::staggered, {{'F', 1.0}, {'S', 4.0}}, {1, 0}, 8.0), "F2 S4 F6 S8 F8");
}

TEST(Schedule, LandsOnlyAtTheEndButInTheMiddleWhenStaggered) {
  const auto first_turn = [](Kind kind, const std::vector<Member>& members) {
    Schedule schedule({kind, {1, 0}, {0.0, 6.0}, 3.0}, members, test::all_read_all(2));
    for (int i = 0; i < 2; ++i)
      schedule.stand(i, members[static_cast<std::size_t>(i)].time, members[static_cast<std::size_t>(i)].next);
    return schedule.next_round()[0];
  };
  const std::vector<Member> at_start = {{0.0, 1.0, true}, {0.0, 3.0, true}};
  EXPECT_FALSE(first_turn(Kind::slowest_first, at_start).land);
  EXPECT_TRUE(first_turn(Kind::slowest_first, {{3.0, 4.0, true}, {3.0, 6.0, true}}).land);
  EXPECT_TRUE(first_turn(Kind::staggered, at_start).land);
  EXPECT_EQ(first_turn(Kind::staggered, at_start).limit, 1.5);
  EXPECT_FALSE(first_turn(Kind::slowest_first, {{0.0, 1.0, false}, {0.0, 6.0, false}}).land)
      << "it ends at t_stop, but it can't land";
}

TEST(Schedule, WhoCanLandEndsAtTheEndAndTheOthersAtTheirLastNodeBeforeIt) {
  EXPECT_EQ(turns(Kind::slowest_first, {{'F', 1.0}, {'S', 2.5}}, {1, 0}, 6.0), "S2.5 F2 S5 F6")
      << "the slow side has finished, so it limits nobody";
  EXPECT_EQ(turns(Kind::slowest_first, {{'F', 1.0, true}, {'S', 2.5, true}}, {1, 0}, 5.6),
            "S2.5 F2 S5 F5 S5.6 F5.6");
  EXPECT_EQ(turns(Kind::fastest_first, {{'F', 1.0}, {'S', 2.5, true}}, {0, 1}, 5.6), "F2 F3 S2.5 F5 S5.6");
  EXPECT_EQ(turns(Kind::parallel, {{'F', 1.0}, {'S', 2.5, true}}, {0, 1}, 5.6), "(F2 S2.5) (F5 S5) S5.6");
}

TEST(Schedule, AnEarlyFinisherBlocksNobody) {
  for (const Kind kind : {Kind::slowest_first, Kind::fastest_first}) {
    EXPECT_EQ(turns(kind, {{'A', 1.0, false, false, 1.5}, {'B', 1.0}}, {0, 1}, 4.0), "A1 B4");
    EXPECT_EQ(turns(kind, {{'A', 1.0}, {'B', 1.0, false, false, 1.5}}, {0, 1}, 4.0), "A1 B1 A4");
  }
  EXPECT_EQ(turns(Kind::parallel, {{'A', 1.0, false, false, 1.5}, {'B', 1.0}}, {0, 1}, 3.0), "(A1 B1) B2 B3");
  EXPECT_EQ(turns(Kind::staggered, {{'F', 1.0, true, false, 1.0}, {'S', 4.0, true}}, {1, 0}, 8.0),
            "F1 S4 S8");
  EXPECT_EQ(turns(Kind::staggered, {{'F', 1.0, true}, {'S', 2.0, true, false, 2.0}}, {1, 0}, 5.0),
            "F1 S2 F5");
}

TEST(Schedule, NobodyMovesWhenNoStepFits) {
  EXPECT_EQ(turns(Kind::slowest_first, {{'A', 3.0}, {'B', 5.0}}, {1, 0}, 2.0), "");
  EXPECT_EQ(turns(Kind::parallel, {{'A', 3.0}, {'B', 5.0, true}}, {1, 0}, 2.0), "B2");
}

TEST(Schedule, NamesAreReadAndWrittenAlike) {
  for (const char* name : {"slowest-first", "fastest-first", "staggered", "parallel"})
    EXPECT_EQ(Schedule::name(Schedule::parse(name)), name);
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument,
                            {"'slowest_first'", "slowest-first, fastest-first, staggered, parallel"},
                            [] { Schedule::parse("slowest_first"); }));
}

}  // namespace
}  // namespace tandem
