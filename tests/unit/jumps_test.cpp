// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/jumps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "tandem/fixed_step.hpp"

namespace tandem {
namespace {

constexpr double no_jump = std::numeric_limits<double>::infinity();

Segment marked(Segment s) {
  mark_jump(s, true);
  return s;
}

/// 1 up to t = 0.23, then 3 + t, with a piece between them that only carries the mark.
struct Jumping {
  Segment pieces[3] = {{0.23, 0.0, {1.0}}, marked({0.23, 0.23, {3.23}}), {9.0, 0.0, {3.0, 1.0}}};
  Signal signal{pieces, 3, 1};
};

TEST(SignalJumps, AreMarkedWithoutAChangeOfAnyValue) {
  const Jumping jumping;
  Jumping plain;
  mark_jump(plain.pieces[1], false);
  for (const double t : {0.0, 0.1, 0.23, 0.3, 5.0}) {
    EXPECT_EQ(jumping.signal.value(t), plain.signal.value(t)) << t;
    EXPECT_EQ(jumping.signal.derivative(t), plain.signal.derivative(t)) << t;
    EXPECT_EQ(jumping.signal.second_derivative(t), plain.signal.second_derivative(t)) << t;
  }
  EXPECT_EQ(jumping.signal.next_jump(0.0), 0.23);
  EXPECT_EQ(jumping.signal.next_jump(0.23), no_jump);
  EXPECT_EQ(plain.signal.next_jump(0.0), no_jump);
}

TEST(SignalJumps, AreWhereTheSignalFromThereOnHasTheValueAfter) {
  const Jumping jumping;
  EXPECT_EQ(jumping.signal.value(0.23), 1.0);
  EXPECT_EQ(jumping.signal.from_jump_at(0.23).value(0.23), 3.23);
  EXPECT_EQ(jumping.signal.from_jump_at(0.23).value(0.5), 3.5);
  EXPECT_EQ(jumping.signal.from_jump_at(0.5).value(0.1), 1.0) << "it has none there";
  EXPECT_TRUE(jumping.signal.from_jump_at(0.23).jumps_at(0.23, TimeTolerance()));
  EXPECT_FALSE(jumping.signal.from_jump_at(0.23).jumps_at(0.3, TimeTolerance()));
  EXPECT_FALSE(jumping.signal.jumps_at(0.0, TimeTolerance()));
}

TEST(Jumps, OfSeveralInputsArePassedOneAfterTheOther) {
  const Jumping first;
  Segment held[2] = {{0.4, 0.1, {7.0}}, marked({no_jump, 0.4, {8.0}})};
  const Signal inputs[] = {first.signal, Signal(held, 2, 0)};
  Jumps jumps(2);
  jumps.begin(inputs, 0.2);
  EXPECT_EQ(jumps.next(), 0.23);
  jumps.pass();
  EXPECT_EQ(jumps.next(), 0.4);
  EXPECT_EQ(jumps.inputs()[0].value(0.23), 3.23);
  EXPECT_EQ(jumps.inputs()[1].value(0.23), 7.0);
  jumps.pass();
  EXPECT_EQ(jumps.next(), no_jump);
  EXPECT_EQ(jumps.inputs()[1].value(0.4), 8.0);
}

/// x' = -x + u by the classical Runge-Kutta method; remembers the ends of the parts that it was asked for.
struct FirstOrder {
  double h = 0.1, x = 0.0;
  std::vector<double> ends = {};
  SubsystemInfo info() const { return {"lag", {{"u", "1"}}, {{"x", "1"}}, {}, {}}; }
  double own_step() const { return h; }
  void start(double, std::span<const double>) { x = 0.0, ends.clear(); }
  void step(const OwnStep& s, std::span<const Signal> u) {
    const double k1 = u[0].value(s.begin) - x, half = s.length / 2.0;
    const double k2 = u[0].value(s.begin + half) - (x + half * k1);
    const double k3 = u[0].value(s.begin + half) - (x + half * k2);
    const double k4 = u[0].value(s.end) - (x + s.length * k3);
    x += s.length / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    ends.push_back(s.end);
  }
  void outputs(double* y) const { y[0] = x; }
};

/// From t = 0.23 on x' = -x + 3 + t, so x = 2 + t + c exp(-t).
double exact_lag(double t) {
  const double at_jump = 1.0 - std::exp(-0.23);
  return t < 0.23 ? 1.0 - std::exp(-t) : 2.0 + t + (at_jump - 2.23) * std::exp(0.23 - t);
}

double error_at_one(double h, bool split) {
  Jumping jumping;
  if (!split) mark_jump(jumping.pieces[1], false);
  FixedStep<FirstOrder> lag(FirstOrder{.h = h});
  std::vector<double> rows(3 * 1000);
  Samples y(rows.data(), 3, 1000);
  const double u0 = 1.0;
  lag.initialize(0.0, 1.0, {&u0, 1}, y);
  lag.advance(1.0, false, {&jumping.signal, 1}, y);
  return std::abs(y.values(y.size() - 1)[0] - exact_lag(1.0));
}

TEST(FixedStepJumps, AreWhereStepsAreSplitSoThatTheOrderStays) {
  EXPECT_NEAR(std::log2(error_at_one(0.1, true) / error_at_one(0.05, true)), 4.0, 0.3);
  EXPECT_LT(error_at_one(0.05, true), 1e-7);
  EXPECT_GT(error_at_one(0.05, false), 1e-3) << "over the break it errs to first order";
}

TEST(FixedStepJumps, GiveNoRowAndLeaveTheGridAsItWas) {
  const Jumping jumping;
  FixedStep<FirstOrder> lag(FirstOrder{});
  std::vector<double> rows(3 * 100);
  Samples y(rows.data(), 3, 100);
  const double u0 = 1.0;
  lag.initialize(0.0, 1.0, {&u0, 1}, y);
  lag.advance(0.4, false, {&jumping.signal, 1}, y);
  ASSERT_EQ(y.size(), 5);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(y.time(k), 0.1 * k);
  EXPECT_EQ(lag.model().ends, (std::vector<double>{0.1, 0.2, 0.23, 0.30000000000000004, 0.4}));
}

TEST(FixedStepJumps, AtTheEndOfAStepSplitNothing) {
  Segment held[2] = {{0.2, 0.0, {1.0}}, marked({no_jump, 0.2, {2.0}})};
  const Signal u(held, 2, 0);
  FixedStep<FirstOrder> lag(FirstOrder{});
  std::vector<double> rows(3 * 100);
  Samples y(rows.data(), 3, 100);
  const double u0 = 1.0;
  lag.initialize(0.0, 1.0, {&u0, 1}, y);
  lag.advance(0.3, false, {&u, 1}, y);
  EXPECT_EQ(lag.model().ends, (std::vector<double>{0.1, 0.2, 0.30000000000000004}));
  FixedStep<FirstOrder> other(FirstOrder{});
  y = Samples(rows.data(), 3, 100);
  other.initialize(0.0, 1.0, {&u0, 1}, y);
  other.advance(0.2, false, {&u, 1}, y);
  const Signal after(held + 1, 1, 0);
  other.advance(0.3, false, {&after, 1}, y);
  EXPECT_EQ(other.model().x, lag.model().x) << "in one call or two, the same bits";
}

/// Two jumps at one time: a relay that is switched, and switched back by what follows from that.
TEST(SignalJumps, ThatMeetAreOne) {
  const Segment pieces[] = {{0.2, 0.0, {1.0}}, marked({0.2, 0.2, {-1.0}}), marked({no_jump, 0.2, {5.0}})};
  const Signal u(pieces, 3, 0);
  EXPECT_EQ(u.from_jump_at(0.2).value(0.2), 5.0);
}

/// y = x + u, which jumps with u.
struct Following : FirstOrder {
  double u_now = 0.0;
  SubsystemInfo info() const { return {"following", {{"u", "1"}}, {{"y", "1"}}, {{0, 0}}, {}}; }
  void start(double t, std::span<const double> u0) { FirstOrder::start(t, u0), u_now = u0[0]; }
  void step(const OwnStep& s, std::span<const Signal> u) {
    FirstOrder::step(s, u);
    u_now = u[0].value(s.end);
  }
  bool jump(double t, std::span<const Signal> u) { return std::exchange(u_now, u[0].value(t)) != u_now; }
  void outputs(double* y) const { y[0] = x + u_now; }
};

/// u jumps at its node 0.2 s. All rows up to `limit`, in calls that have room for so many.
std::vector<double> rows_of_following(double limit, std::int64_t room) {
  Segment held[2] = {{0.2, 0.0, {1.0}}, marked({no_jump, 0.2, {2.0}})};
  FixedStep<Following> following(Following{});
  std::vector<double> rows(3 * 100);
  Samples y(rows.data(), 3, 1);
  const double u0 = 1.0;
  Clock clock = following.initialize(0.0, 1.0, {&u0, 1}, y);
  for (Stop stop = Stop::samples_full; stop == Stop::samples_full; stop = clock.stop) {
    const int begun = clock.time < 0.2 ? 0 : 1;  // who stands at a jump is given what begins there
    const Signal u(held + begun, 2 - begun, 0);
    y = Samples(rows.data(), 3, y.size() + room, y.size());
    clock = following.advance(limit, false, {&u, 1}, y);
  }
  rows.resize(static_cast<std::size_t>(3 * y.size()));
  return rows;
}

TEST(FixedStepJumps, SecondRowsAreTheSameWhereverCallsBegin) {
  const auto rows = rows_of_following(0.4, 50);
  ASSERT_EQ(rows.size(), 3 * 6U);
  EXPECT_EQ(rows[3 * 2], 0.2);
  EXPECT_EQ(rows[3 * 3], 0.2);
  EXPECT_EQ(rows[3 * 3 + 1], 1.0) << "marked";
  EXPECT_EQ(rows[3 * 3 + 2], rows[3 * 2 + 2] + 1.0);
  for (const std::int64_t room : {1, 2, 3}) EXPECT_EQ(rows_of_following(0.4, room), rows) << room;
}

/// What jumps where the call ends is for the next one, which may know more by then.
TEST(FixedStepJumps, WhereACallEndsGiveNoRow) { EXPECT_EQ(rows_of_following(0.2, 50).size(), 3 * 3U); }

}  // namespace
}  // namespace tandem
