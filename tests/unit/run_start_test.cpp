// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a schedule can't honour is refused with a sentence, before any step; what the order and the steps come
// out as.
#include <gtest/gtest.h>

#include <cmath>

#include "refusal.hpp"
#include "run_bench.hpp"
#include "scripted.hpp"

namespace tandem {
namespace {

using test::refuses;
using test::RunBench;
using test::Scripted;

/// "slow" (1 s) and "fast" (0.25 s), which read one another as asked for.
class SchemeTest : public testing::Test {
 protected:
  testing::AssertionResult refuses_scheme(const std::string& schedule, const std::string& to_fast,
                                          const std::string& to_slow, const std::vector<std::string>& texts) {
    RunBench bench;
    couple(bench, schedule, to_fast, to_slow);
    const auto result = refuses(ErrorCode::not_supported, texts, [&] { bench.run(4.0); });
    EXPECT_TRUE(slow.calls.empty() && fast.calls.empty()) << "before any step";
    return result;
  }
  void couple(RunBench& bench, const std::string& schedule, const std::string& to_fast,
              const std::string& to_slow) {
    bench.add("slow", slow).add("fast", fast).schedule(schedule);
    bench.connect("slow.y", "fast.u", to_fast).connect("fast.y", "slow.u", to_slow);
  }
  Scripted slow = test::listener(1.0), fast = test::listener(0.25);
};

TEST_F(SchemeTest, MeanNeedsASourceAheadOfItsReader) {
  EXPECT_TRUE(refuses_scheme("parallel", "lagrange1", "mean",
                             {"slow.u", "mean", "ahead", "'fast'", "'slow'", "parallel"}));
  EXPECT_TRUE(refuses_scheme("slowest-first", "lagrange1", "mean",
                             {"slow.u", "mean", "'fast' is not ahead of 'slow'"}));
  EXPECT_TRUE(refuses_scheme("fastest-first", "mean", "lagrange1",
                             {"fast.u", "mean", "'slow' is not ahead of 'fast'"}));
  RunBench honoured;
  couple(honoured, "fastest-first", "lagrange1", "mean");
  EXPECT_NO_THROW(honoured.run(4.0));
  RunBench other_way;
  couple(other_way, "slowest-first", "mean", "lagrange1");
  EXPECT_NO_THROW(other_way.run(4.0));
}

TEST_F(SchemeTest, AMeanOverStepsInWhichNoSampleMayLieIsTold) {
  for (const bool of_slow : {true, false}) {
    RunBench bench;
    couple(bench, of_slow ? "slowest-first" : "fastest-first", of_slow ? "mean" : "lagrange1",
           of_slow ? "lagrange1" : "mean");
    bench.run(4.0);
    const auto& notes = bench.coordinator->notes();
    ASSERT_EQ(notes.size(), of_slow ? 1U : 0U);
    if (of_slow) {
      EXPECT_NE(notes[0].find("input fast.u is the mean over an own step, which is shorter than those of "
                              "'slow'"),
                std::string::npos)
          << notes[0];
    }
  }
}

TEST_F(SchemeTest, MatchedHoldNeedsTurns) {
  EXPECT_TRUE(
      refuses_scheme("parallel", "matched_hold", "matched_hold", {"fast.u", "matched_hold", "parallel"}));
  for (const char* schedule : {"slowest-first", "fastest-first", "staggered"}) {
    RunBench bench;
    couple(bench, schedule, "matched_hold", "matched_hold");
    EXPECT_NO_THROW(bench.run(4.0)) << schedule;
  }
}

TEST_F(SchemeTest, StaggeredTakesMatchedHoldOnly) {
  EXPECT_TRUE(refuses_scheme("staggered", "matched_hold", "lagrange2",
                             {"slow.u", "lagrange2", "staggered", "matched_hold only"}));
  EXPECT_TRUE(refuses_scheme("staggered", "mean", "matched_hold", {"fast.u", "mean", "staggered"}));
}

TEST_F(SchemeTest, StaggeredCouplesTwo) {
  Scripted third = test::listener(0.5);
  RunBench bench;
  couple(bench, "staggered", "matched_hold", "matched_hold");
  bench.add("third", third).connect("slow.y", "third.u", "matched_hold");
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"staggered", "two", "3"}, [&] { bench.run(4.0); }));
}

TEST_F(SchemeTest, StaggeredSaysThatAFirstOrderPartRemainsWhereNoNodeIsInTheMiddle) {
  for (const double step : {0.25, 0.2, 0.3}) {
    fast = test::listener(step);
    RunBench bench;
    couple(bench, "staggered", "matched_hold", "matched_hold");
    bench.run(4.0);
    std::string notes;
    for (const std::string& note : bench.coordinator->notes()) notes += note + "\n";
    EXPECT_EQ(notes.find("first order") != std::string::npos, step != 0.25) << notes;
  }
}

TEST_F(SchemeTest, SettingsWithoutEffectAreTold) {
  RunBench bench;
  couple(bench, "parallel", "lagrange1", "lagrange1");
  bench.coordination.order = {"slow", "fast"};
  bench.run(4.0);
  ASSERT_EQ(bench.coordinator->notes().size(), 1U);
  EXPECT_NE(bench.coordinator->notes()[0].find("order has no effect"), std::string::npos);
  RunBench turns;
  couple(turns, "slowest-first", "lagrange1", "lagrange1");
  turns.coordination.communication_step = 0.5;
  turns.run(4.0);
  ASSERT_EQ(turns.coordinator->notes().size(), 1U);
  EXPECT_NE(turns.coordinator->notes()[0].find("communication_step has no effect"), std::string::npos);
}

TEST_F(SchemeTest, AnOwnStepThatIsNothingBesideTheEndIsRefused) {
  fast = test::listener(1e-16);
  RunBench bench;
  couple(bench, "slowest-first", "lagrange1", "lagrange1");
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'fast'", "1e-16 s", "4 s", "more than"},
                      [&] { bench.run(4.0); }));
}

TEST(Scheme, AMemoryNeedsAFixedStep) {
  SubsystemInfo info = test::listener(1.0).info();
  info.abilities.chooses_step = true;
  Scripted source = test::listener(0.5),
           reader(info, 1.0, [](double, const auto&, double* y) { y[0] = 0.0; });
  RunBench bench;
  bench.add("source", source).add("reader", reader);
  bench.connect("source.y", "reader.u", "lagrange1", Lag::memory).connect("reader.y", "source.u");
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"reader.u", "memory", "chooses its steps", "delay"},
                      [&] { bench.run(4.0); }));
}

/// The leaders-first order of a run of subsystems a, b, c with steps 2, 1 and 3.
testing::AssertionResult has_order(const std::string& schedule, const std::vector<std::string>& named,
                                   const std::vector<int>& order) {
  Scripted a = test::source(2.0, [](double) { return 0.0; }),
           b = test::source(1.0, [](double) { return 0.0; }),
           c = test::source(3.0, [](double) { return 0.0; });
  RunBench bench;
  bench.add("a", a).add("b", b).add("c", c).schedule(schedule);
  bench.coordination.order = named;
  bench.run(6.0);
  const auto found = bench.coordinator->schedule().order();
  if (std::vector<int>(found.begin(), found.end()) == order) return testing::AssertionSuccess();
  return testing::AssertionFailure() << testing::PrintToString(found);
}

TEST(Order, GoesByTheOwnStepsOrAsNamed) {
  EXPECT_TRUE(has_order("slowest-first", {}, {2, 0, 1}));
  EXPECT_TRUE(has_order("fastest-first", {}, {1, 0, 2}));
  EXPECT_TRUE(has_order("slowest-first", {"b", "c", "a"}, {1, 2, 0}));
  EXPECT_TRUE(has_order("fastest-first", {"b", "c", "a"}, {0, 2, 1})) << "named slowest first all the same";
}

TEST(Order, NamesEachSubsystemOnce) {
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"coordination.order", "'c'"}, [] {
    has_order("slowest-first", {"a", "b"}, {});
  }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"coordination.order", "'b'", "twice"}, [] {
    has_order("slowest-first", {"a", "b", "b"}, {});
  }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"coordination.order", "'d'"}, [] {
    has_order("slowest-first", {"a", "b", "c", "d"}, {});
  }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"coordination.order", "'d'"}, [] {
    has_order("slowest-first", {"a", "b", "d"}, {});
  }));
}

TEST(CommunicationStep, IsFiniteAndAboveZero) {
  for (const double h : {0.0, -1.0, double{NAN}, double{INFINITY}}) {
    Scripted a = test::source(1.0, [](double) { return 0.0; });
    RunBench bench;
    bench.add("a", a).coordination.communication_step = h;
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"communication_step"}, [&] { bench.run(2.0); })) << h;
  }
}

/// A run of one subsystem with that own step, which can cut one or not.
testing::AssertionResult notes_of_step(double step, bool lands, const TimeSpan& span,
                                       const std::string& note) {
  SubsystemInfo info = test::listener(step).info();
  info.abilities.lands = lands;
  info.inputs[0].start = 0.0;
  Scripted a(info, step, [](double, const auto&, double* y) { y[0] = 0.0; });
  RunBench bench;
  bench.add("a", a).make(span.stop, span.start).initialize();
  std::string all;
  for (const std::string& line : bench.coordinator->notes()) all += line + "\n";
  if (note.empty() ? all.empty() : all.find(note) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "notes: " << all;
}

TEST(Span, IsAtLeastAnOwnStepOfWhoCanNotShortenOne) {
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"'a'", "own step of 5 s", "the span, 2 s", "stand still"}, [] {
        EXPECT_TRUE(notes_of_step(5.0, false, {1.0, 3.0}, ""));
      }));
  EXPECT_TRUE(notes_of_step(5.0, true, {1.0, 3.0},
                            "'a' has an own step of 5 s, longer than the span, 2 s: it takes one"));
  EXPECT_TRUE(notes_of_step(2.0, false, {1.0, 3.0}, ""));
  EXPECT_TRUE(notes_of_step(0.1, false, {0.2, 0.3}, "")) << "0.2 + 0.1 is an ulp above 0.3";
}

// eps 1e10 s = 2.2e-6 s, of a step of 1 ms 2.2e-3.
TEST(Span, SoFarOffThatTimesLoseTheDigitsOfAStepIsToldOrRefused) {
  EXPECT_TRUE(notes_of_step(1e-3, true, {0.0, 1e3}, ""));
  EXPECT_TRUE(notes_of_step(1e-3, true, {1e10, 1e10 + 1.0},
                            "s, which times of the size of 1e+10 s hold to 0.0022 of itself only"));
  EXPECT_TRUE(notes_of_step(1e-3, true, {-1e10, 0.0}, "hold to 0.0022 of itself"));
  for (const double step : {1e-3, 1e-2})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'a'", "too small to be told from 0"}, [step] {
      EXPECT_TRUE(notes_of_step(step, true, {1e13, 1e13 + 1.0}, ""));
    }));
}

TEST(Span, EndsAfterItsStart) {
  for (const auto& [from, to] :
       {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, double{INFINITY}}, {double{NAN}, 1.0}, {1e17, 1e17 + 16.0}}) {
    Scripted a = test::source(1.0, [](double) { return 0.0; });
    RunBench bench;
    bench.add("a", a);
    EXPECT_TRUE(
        refuses(ErrorCode::invalid_argument, {"does not end after its start"}, [&] { bench.run(to, from); }))
        << from << " " << to;
  }
}

}  // namespace
}  // namespace tandem
