// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "refusal.hpp"
#include "run_bench.hpp"
#include "scripted.hpp"

namespace tandem {
namespace {

using test::added;
using test::connection;
using test::refuses;
using test::RunBench;
using test::Scripted;

/// What a subsystem was last initialized with.
const std::vector<double>& start(const Scripted& s) { return s.starts.back(); }

TEST(FirstSamples, PassThroughAChainWhateverItsOrder) {
  Scripted c = test::mirror(0.1), b = test::mirror(0.1), a = test::source(0.1, [](double) { return 5.0; });
  RunBench bench;
  bench.add("c", c).add("b", b).add("a", a).connect("b.y", "c.u").connect("a.y", "b.u");
  EXPECT_EQ(bench.run(0.2).value(0, 0), 5.0);
  EXPECT_TRUE(std::isnan(c.starts.front()[0])) << "what is not known yet is NaN";
  EXPECT_EQ(start(c)[0], 5.0);
  EXPECT_EQ(start(b)[0], 5.0);
}

TEST(FirstSamples, AreFoundWhereEachNeedsTheOthersFirstOutput) {
  // "state" feeds nothing through, "mirror" its input: u of each is the state, 3.
  const SubsystemInfo info{"state", {{"u", "1"}}, {{"y", "1"}}, {}, {}};
  Scripted state(info, 0.1, [](double, const auto&, double* y) { y[0] = 3.0; }), mirror = test::mirror(0.1);
  RunBench bench;
  bench.add("mirror", mirror)
      .add("state", state)
      .connect("state.y", "mirror.u")
      .connect("mirror.y", "state.u")
      .run(0.2);
  EXPECT_TRUE(std::isnan(mirror.starts.front()[0]));
  EXPECT_EQ(start(mirror)[0], 3.0);
  EXPECT_EQ(start(state)[0], 3.0);
  EXPECT_EQ(bench.recording.value(0, 0), 3.0) << "the sample of the last initialize is the one that counts";
}

TEST(FirstSamples, OfASumAreTheSumWithGainsAndOffsets) {
  Scripted a = test::source(0.1, [](double) { return 5.0; }),
           b = test::source(0.1, [](double) { return 7.0; }), reader = test::mirror(0.1);
  RunBench bench;
  bench.add("reader", reader).add("a", a).add("b", b);
  Connection from_a = added(connection("a.y", "reader.u"));
  from_a.gain = 2.0;
  from_a.offset = 0.5;
  bench.topology.connect(from_a);
  bench.topology.connect(added(connection("b.y", "reader.u")));
  bench.run(0.2);
  EXPECT_EQ(start(reader)[0], 2.0 * 5.0 + 0.5 + 7.0);
}

TEST(FirstSamples, OfAnUnconnectedInputAreItsStartValue) {
  Scripted reader = test::mirror(0.1);
  RunBench bench;
  bench.add("reader", reader).topology.set_start("reader.u", 4.0);
  EXPECT_EQ(bench.run(0.2).value(0, 2), 4.0);
  EXPECT_EQ(reader.starts, (std::vector<std::vector<double>>{{4.0}}));
}

TEST(FirstSamples, OfAConnectedInputComeFromItsSourceNotFromItsStartValue) {
  for (const Lag lag : {Lag::none, Lag::memory, Lag::delay}) {
    Scripted reader = test::mirror(0.1), a = test::source(0.1, [](double) { return 5.0; });
    RunBench bench;
    bench.add("reader", reader)
        .add("a", a)
        .connect("a.y", "reader.u", "lagrange1", lag)
        .topology.set_start("reader.u", 4.0);
    bench.run(0.2);
    EXPECT_EQ(start(reader)[0], 5.0);
  }
}

/// a and b mirror each other; the line to a has a lag.
RunBench loop(Scripted& a, Scripted& b, Lag lag) {
  RunBench bench;
  bench.add("a", a).add("b", b).connect("a.y", "b.u").connect("b.y", "a.u", "lagrange0", lag);
  return bench;
}

TEST(FirstSamples, OfALoopThatIsBrokenTakeTheStartValueOfItsBreak) {
  for (const Lag lag : {Lag::memory, Lag::delay}) {
    Scripted a = test::mirror(0.1), b = test::mirror(0.1);
    RunBench bench = loop(a, b, lag);
    bench.topology.set_start("a.u", 2.5);
    bench.run(0.5);
    EXPECT_EQ(start(a)[0], 2.5);
    EXPECT_EQ(start(b)[0], 2.5);
    EXPECT_EQ(bench.recording.value(1, 5), 2.5);
  }
}

TEST(FirstSamples, OfALoopThatIsBrokenNeedAStartValue) {
  Scripted a = test::mirror(0.1), b = test::mirror(0.1);
  RunBench bench = loop(a, b, Lag::memory);
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"a.u", "loop", "no start value"}, [&] { bench.run(0.5); }));
  bench.topology.set_start("b.u", 1.0);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"a.u"}, [&] { bench.run(0.5); }))
      << "b's is not where the loop is broken";
}

TEST(FirstSamples, BehindABrokenLoopNeedNoStartValueOfTheirOwn) {
  for (const double unused : {double{NAN}, -1.0}) {
    Scripted behind = test::mirror(0.1), a = test::mirror(0.1), b = test::mirror(0.1);
    RunBench bench;
    bench.add("behind", behind).add("a", a).add("b", b);
    bench.connect("b.y", "behind.u", "lagrange0", Lag::memory);
    bench.connect("a.y", "b.u")
        .connect("b.y", "a.u", "lagrange0", Lag::memory)
        .topology.set_start("a.u", 2.5);
    if (unused == -1.0) bench.topology.set_start("behind.u", unused);
    EXPECT_NO_THROW(bench.run(0.5)) << "the line to 'behind' has a memory too, but closes no loop";
    EXPECT_EQ(start(behind)[0], 2.5);
  }
}

/// A relay gives 1, and -1 where its input is known and above 2: no output follows an input at once.
Scripted relay() {
  const SubsystemInfo info{"relay", {{"u", "1"}}, {{"y", "1"}}, {}, {}};
  return {info, 0.1, [](double, const auto& u, double* y) { y[0] = u[0] > 2.0 ? -1.0 : 1.0; }};
}

TEST(FirstSamples, ThatFollowAnInputAtTheStartAloneArePassedOnAgain) {
  for (const bool relay_first : {true, false}) {
    Scripted one = relay(), two = relay(), a = test::source(0.1, [](double) { return 5.0; }),
             reader = test::mirror(0.1);
    RunBench bench;
    if (relay_first) bench.add("two", two).add("one", one);
    bench.add("reader", reader).add("a", a);
    if (!relay_first) bench.add("one", one).add("two", two);
    Connection scaled = connection("one.y", "two.u");
    scaled.gain = -3.0;
    bench.topology.connect(scaled);
    bench.connect("a.y", "one.u").connect("two.y", "reader.u").run(0.2);
    EXPECT_EQ(start(two)[0], 3.0);
    EXPECT_EQ(start(reader)[0], -1.0);
    EXPECT_EQ(bench.recording.value(relay_first ? 2 : 0, 0), -1.0);
  }
}

/// y = -u with |u| = 5 from the start on: what one gives is what the other can't have.
TEST(FirstSamples, ThatContradictEachOtherEndAllTheSame) {
  Scripted one = relay(), two = relay();
  RunBench bench;
  bench.add("one", one).add("two", two);
  for (const auto& [from, to, gain] :
       {std::tuple("one.y", "two.u", -5.0), std::tuple("two.y", "one.u", 5.0)}) {
    Connection scaled = connection(from, to);
    scaled.gain = gain;
    bench.topology.connect(scaled);
  }
  EXPECT_NO_THROW(bench.run(0.2));
}

}  // namespace
}  // namespace tandem
