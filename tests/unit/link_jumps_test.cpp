// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Outputs of a source with events: each is cut where it jumps itself, and nowhere else.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "connection.hpp"
#include "link_bench.hpp"
#include "tandem/coordinator/exchange.hpp"

namespace tandem {
namespace {

double smooth(double t) { return std::sin(2.0 * t); }
double before_jump(double t) { return t * t * t - t; }
double after_jump(double t) { return 7.0 - 2.0 * t + 3.0 * t * t; }

/// Output a jumps at 0.35 s, between the nodes 0.1 s apart; b does not.
struct CutBench : test::LinkBench {
  CutBench() : LinkBench("lagrange3", 0.0, {0, 0}, {1, 1}, 0.05) {
    for (const double t : {0.0, 0.1, 0.2, 0.3, 0.35}) give(t, before_jump(t), smooth(t));
    give(0.35, after_jump(0.35), smooth(0.35), 0.0, 0.0, true);
    for (const double t : {0.4, 0.5, 0.6, 0.7}) give(t, after_jump(t), smooth(t));
  }
};

TEST(LinkJumps, AreMarkedInTheLaneThatJumpsAlone) {
  CutBench bench;
  EXPECT_EQ(bench.read(0.3, 0.4, 0).next_jump(0.3), 0.35);
  EXPECT_TRUE(std::isinf(bench.read(0.3, 0.4, 1).next_jump(0.3)));
}

TEST(LinkJumps, NoPolynomialGoesThroughOne) {
  CutBench bench;
  const Signal a = bench.read(0.0, 0.1, 0);
  EXPECT_DOUBLE_EQ(a.value(0.35), before_jump(0.35));
  EXPECT_NEAR(a.value(0.33), before_jump(0.33), 1e-15) << "a cubic before it";
  const Signal later = a.from_jump_at(0.35);
  EXPECT_DOUBLE_EQ(later.value(0.35), after_jump(0.35));
  const double line = after_jump(0.35) + (after_jump(0.4) - after_jump(0.35)) * (0.03 / 0.05);
  EXPECT_NEAR(later.value(0.38), line, 1e-14) << "through the two samples that there are";
  EXPECT_NEAR(later.value(0.55), after_jump(0.55), 1e-14) << "a parabola, as of the third on";
}

/// By cubics, that of 0.31 s through 0.35, 0.2, 0.1 and 0 s. A line from 0.35 s on errs by 1e-3.
TEST(LinkJumps, OfOneOutputCutNoOther) {
  CutBench bench;
  const Signal b = bench.read(0.0, 0.1, 1);
  constexpr double bound = 16.0 / 24.0 * 0.04 * 0.11 * 0.21 * 0.31;
  for (const double t : {0.31, 0.34, 0.37, 0.45, 0.55, 0.65}) EXPECT_NEAR(b.value(t), smooth(t), bound) << t;
}

/// Who stands at a jump reads what is after it, also where it is not the first lane that jumps.
TEST(LinkJumps, ReadFromThereAreBehindThem) {
  CutBench bench;
  const Signal a = bench.read(0.35, 0.4, 0);
  EXPECT_DOUBLE_EQ(a.value(0.35), after_jump(0.35));
  test::LinkBench turned("lagrange3", 0.0, {0, 0}, {1, 1}, 0.05);
  for (const double t : {0.0, 0.1, 0.2, 0.3, 0.35}) turned.give(t, smooth(t), before_jump(t));
  turned.give(0.35, smooth(0.35), after_jump(0.35), 0.0, 0.0, true);
  EXPECT_DOUBLE_EQ(turned.read(0.35, 0.4, 1).value(0.35), after_jump(0.35));
}

/// Its reader stands at 0.25 s and has let go what was before; it goes on with what is left.
TEST(LinkJumps, OneSegmentStaysWhereTheSourceTakesRowsBack) {
  for (const char* how : {"held", "lagrange0"}) {
    test::LinkBench bench(how, 0.0, {0, 0}, {1, 1}, 0.05);
    for (const double t : {0.0, 0.1, 0.2, 0.3}) bench.give(t, 1.0 + t);
    bench.read(0.25, 0.3);
    bench.history().withdraw(3);
    bench.link().withdraw(3);
    EXPECT_EQ(bench.read(0.25, 0.3).value(0.25), 1.0) << how;
    bench.give(0.15, 2.0);
    EXPECT_EQ(bench.read(0.25, 0.3).value(0.25), 2.0) << how;
  }
}

/// The sum of a relay, which jumps at 0.35 s, and of a parabola on another grid, whichever comes first.
void expect_jumps_of_sum(const std::string& relay) {
  SubsystemInfo switching{"switching", {}, {{"y", "1"}}, {}, {}};
  switching.abilities.events = true;
  const SubsystemInfo source{"source", {}, {{"y", "1"}}, {}, {}}, reader{"reader", {{"u", "1"}}, {}, {}, {}};
  Topology topology;
  topology.add(relay, switching);
  topology.add("source", source);
  topology.add("reader", reader);
  for (const std::string& from : {relay + ".y", std::string("source.y")})
    topology.connect(test::added(test::connection(from, "reader.u", "lagrange2")));
  const std::int64_t capacities[] = {32, 32, 32};
  Exchange exchange(topology, 0.0, LinkTimes{{1.0, 1.0, 1.0}, 0.0, {0.05, 0.0, 0.0}}, capacities);
  const auto give = [&](int who, double t, double y, bool jump = false) {
    *exchange.history(who).room().append(t, jump) = y;
    exchange.commit(who, t);
  };
  for (const double t : {0.0, 0.1, 0.2, 0.3, 0.35}) give(0, t, 1.0);
  give(0, 0.35, -1.0, true);
  for (int k = 0; k < 6; ++k) give(1, 0.12 * k, 0.12 * k * 0.12 * k);
  const auto expect = [&] {
    const Signal u = exchange.inputs(2, 0.25, 0.5, 0.5)[0];
    EXPECT_EQ(u.next_jump(0.25), 0.35);
    EXPECT_NEAR(u.value(0.35), 1.0 + 0.35 * 0.35, 1e-14);
    EXPECT_NEAR(u.from_jump_at(0.35).value(0.35), -1.0 + 0.35 * 0.35, 1e-14);
    for (const double t : {0.26, 0.34, 0.36, 0.45, 0.5})
      EXPECT_NEAR((t < 0.35 ? u : u.from_jump_at(0.35)).value(t), (t < 0.35 ? 1.0 : -1.0) + t * t, 1e-14)
          << t;
  };
  expect();
  for (const double t : {0.4, 0.5}) give(0, t, -1.0);
  expect();
}

TEST(LinkJumps, AreThoseOfASumToo) {
  for (const char* relay : {"relay", "that"}) {
    SCOPED_TRACE(relay);
    expect_jumps_of_sum(relay);
  }
}

/// One that lags sees several jumps of its source after each other, and none that was taken back.
TEST(LinkJumps, AreEachKnownToOneThatLags) {
  test::LinkBench bench("lagrange1", 0.25, {0, 0}, {1, 1}, 0.05);
  for (const double t : {0.0, 0.1}) bench.give(t, 1.0);
  for (const double t : {0.2, 0.3}) {
    bench.give(t, 1.0);
    bench.give(t, 2.0 * t, 0.0, 0.0, 0.0, true);
  }
  EXPECT_EQ(bench.link().next_break(0.1), 0.2 + 0.25);
  EXPECT_EQ(bench.link().next_break(0.2 + 0.25), 0.3 + 0.25);
  bench.history().withdraw(2);
  bench.link().withdraw(2);
  EXPECT_EQ(bench.link().next_break(0.1), 0.2 + 0.25);
  EXPECT_EQ(bench.link().next_break(0.2 + 0.25), Member::never);
}

/// The sum of lane a of a source that jumps at 0.35 s, or of b, which does not, and of a line that has a node
/// there.
struct SumAtJump {
  explicit SumAtJump(const std::string& lane) {
    topology.add("source", source);
    topology.add("line", line);
    topology.add("reader", reader);
    for (const std::string& from : {"source." + lane, std::string("line.y")})
      topology.connect(test::added(test::connection(from, "reader.u", "lagrange1")));
    const std::int64_t capacities[] = {32, 32, 32};
    exchange.emplace(topology, 0.0, LinkTimes{{1.0, 1.0, 1.0}, 0.0, {0.05, 0.0, 0.0}}, capacities);
    for (const double t : {0.0, 0.1, 0.2, 0.3}) give(0, t, 1.0, t * t);
    give(0, 0.35, 1.0, 0.35 * 0.35);
    give(0, 0.35, -1.0, 0.35 * 0.35, true);
    for (const double t : {0.0, 0.15, 0.35}) give(1, t, t);
  }
  void give(int who, double t, double y, double b = 0.0, bool jump = false) {
    double* const row = exchange->history(who).room().append(t, jump);
    row[0] = y;
    if (who == 0) row[1] = b;
    exchange->commit(who, t);
  }
  Signal from(double time) { return exchange->inputs(2, time, 0.5, 0.5)[0]; }

  SubsystemInfo source{"source", {}, {{"a", "1"}, {"b", "1"}}, {}, {.events = true}},
      line{"line", {}, {{"y", "1"}}, {}, {}}, reader{"reader", {{"u", "1"}}, {}, {}, {}};
  Topology topology;
  std::optional<Exchange> exchange;
};

TEST(LinkJumps, WhereACallBeginsTheSumBeginsWithThem) {
  SumAtJump sum("a");
  const Signal u = sum.from(0.35);
  EXPECT_TRUE(u.jumps_at(0.35, TimeTolerance()));
  EXPECT_NEAR(u.value(0.35), -1.0 + 0.35, 1e-15);
}

/// The parabola b goes on by the line through its last two own nodes, 0.3 and 0.35 s, or from the second row
/// of that time by another one: whichever of them it is, also in a sum.
TEST(LinkJumps, BehindTheSecondRowOfATimeASumGoesOnAsItsTermsDo) {
  SumAtJump sum("b");
  const Signal whole = sum.from(0.2), rest = sum.from(0.4);
  for (const double t : {0.42, 0.5}) EXPECT_EQ(whole.value(t), rest.value(t)) << t;
}

}  // namespace
}  // namespace tandem
