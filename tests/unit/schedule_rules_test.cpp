// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "schedule_bench.hpp"

namespace tandem {
namespace {

using test::ScheduleBench;
using test::Walker;
using Kind = Schedule::Kind;

/// coordinator.md's rules, word for word and without any care for speed.
struct Rules {
  std::vector<Member> clocks;  ///< in the order of leading
  double t_start, t_stop, H;

  double tol(double a, double b) const {
    return 4.0 * std::numeric_limits<double>::epsilon() *
           std::max({std::abs(a), std::abs(b), std::abs(t_start)});
  }
  bool before(double a, double b) const { return a < b - tol(a, b); }
  bool finished(const Member& m) const { return !before(m.time, t_stop) || before(t_stop, m.next); }
  double shortest(double limit, std::size_t from, std::size_t to, double Member::*what) const {
    for (std::size_t q = from; q < to; ++q)
      if (!finished(clocks[q])) limit = std::min(limit, clocks[q].*what);
    return limit;
  }

  /// Position and limit of the turn in slowest-first and fastest-first.
  std::optional<std::pair<std::size_t, double>> in_turn() const {
    const std::size_t n = clocks.size();
    std::size_t p = n;
    for (std::size_t q = 0; q < n; ++q)
      if (!finished(clocks[q]) && (p == n || before(clocks[q].next, clocks[p].next))) p = q;
    if (p == n) return {};
    const auto first_behind = [&] {
      for (std::size_t q = 0; q < p; ++q)
        if (!finished(clocks[q]) && before(clocks[q].time, clocks[p].next)) return q;
      return p;
    };
    for (std::size_t q = first_behind(); q != p; q = first_behind()) p = q;
    const double next = clocks[p].next;
    double limit = std::min(shortest(t_stop, 0, p, &Member::time), shortest(t_stop, p + 1, n, &Member::next));
    if (clocks[p].one_step) limit = next;
    return std::pair{p, std::max(next, std::min(t_stop, limit))};
  }

  std::optional<std::pair<std::size_t, double>> staggered() const {  // clocks: slow, fast
    const Member &slow = clocks[0], &fast = clocks[1];
    const double mid = slow.time + (slow.next - slow.time) / 2.0;
    if (!finished(slow) && !finished(fast) && before(fast.time, mid))
      return std::pair{1U, fast.lands ? mid : std::max(mid, fast.next)};
    if (!finished(slow)) return std::pair{0U, slow.next};
    if (!finished(fast)) return std::pair{1U, t_stop};
    return {};
  }

  /// The communication point T; nothing at the end.
  std::optional<double> parallel() const {
    double smallest = INFINITY;
    for (const Member& m : clocks)
      if (!finished(m)) smallest = std::min(smallest, m.next);
    if (smallest == INFINITY) return {};
    std::int64_t k = 0;
    while (before(t_start + static_cast<double>(k) * H, smallest)) ++k;
    return std::min(t_start + static_cast<double>(k) * H, t_stop);
  }
};

constexpr double ulps =
    1e-15;  // limits are picked, not computed: equal but for a cut at t_stop within the tolerance

void expect_turn(std::span<const Turn> round, const std::vector<int>& order,
                 const std::optional<std::pair<std::size_t, double>>& rule, double t_stop) {
  ASSERT_EQ(round.empty(), !rule);
  if (!rule) return;
  ASSERT_EQ(round.size(), 1U);
  ASSERT_EQ(round[0].who, order[rule->first]);
  ASSERT_NEAR(round[0].limit, rule->second, ulps * std::abs(t_stop));
}

void expect_round(std::span<const Turn> round, const std::vector<int>& order, const Rules& rules) {
  const auto T = rules.parallel();
  std::vector<char> moves(order.size());
  for (const Turn& turn : round) {
    ASSERT_TRUE(T);
    moves[static_cast<std::size_t>(turn.who)] = 1;
    ASSERT_NEAR(turn.limit, *T, 4.0 * ulps * std::max(std::abs(*T), std::abs(rules.t_start)));
  }
  for (std::size_t p = 0; p < order.size(); ++p) {
    const Member& m = rules.clocks[p];
    ASSERT_EQ(moves[static_cast<std::size_t>(order[p])] == 1,
              T && !rules.finished(m) && !rules.before(*T, m.next));
  }
}

struct Case {
  Kind kind;
  std::vector<Walker> walkers;
  std::vector<int> order;
  double t_start, t_stop, H;
};

/// Steps to the end, comparing each round with the rules, and checks how the run ends.
void follow(const Case& c) {
  ScheduleBench bench(c.walkers, c.kind, c.order, {c.t_start, c.t_stop}, c.H,
                      test::all_read_all(c.walkers.size()));
  const TimeTolerance tolerance(c.t_start);
  for (int round_number = 0;; ++round_number) {
    ASSERT_LT(round_number, 100'000);
    Rules rules{{}, c.t_start, c.t_stop, c.H};
    for (const int i : c.order) rules.clocks.push_back(bench.clock(i));
    const auto round = bench.schedule().next_round();
    if (c.kind == Kind::parallel)
      expect_round(round, c.order, rules);
    else
      expect_turn(round, c.order, c.kind == Kind::staggered ? rules.staggered() : rules.in_turn(), c.t_stop);
    if (round.empty() || testing::Test::HasFatalFailure()) break;
    for (const Turn& turn : std::vector<Turn>(round.begin(), round.end())) {
      const Member before = bench.clock(turn.who);
      ASSERT_FALSE(tolerance.before(c.t_stop, turn.limit)) << "nobody is asked for anything beyond the end";
      ASSERT_FALSE(turn.land && !before.lands);
      bench.take(turn);
      ASSERT_GT(bench.time(turn.who), before.time) << "each turn is progress";
    }
  }
  for (std::size_t i = 0; i < c.walkers.size(); ++i) {
    if (!c.walkers[i].lands || c.walkers[i].finishes < c.t_stop) continue;
    ASSERT_FALSE(tolerance.before(bench.time(static_cast<int>(i)), c.t_stop))
        << "who can land ends at the end";
  }
}

TEST(ScheduleRules, HoldForAThousandSetsOfSubsystems) {
  std::mt19937_64 random(7);
  const auto pick = [&random](int count) {
    return static_cast<std::size_t>(std::uniform_int_distribution(0, count - 1)(random));
  };
  const double ratios[] = {0.7, 1.5, 2.5, 3.0, 7.0, 30.0, 30.7, 10.0 * std::numbers::pi, std::sqrt(2.0), 1.0};
  const double starts[] = {0.0, 0.0, -1.0, 17.3, -250.0, 1e5};
  for (int i = 0; i < 1500; ++i) {
    Case c{static_cast<Kind>(i % 4), {}, {}, starts[pick(6)], 0.0, 0.0};
    const std::size_t n = c.kind == Kind::staggered ? 2 : 1 + pick(4);
    const double h = 0.01 * static_cast<double>(1 + pick(9));
    for (std::size_t k = 0; k < n; ++k) {
      c.walkers.push_back(
          {static_cast<char>('A' + k), k == 0 ? h : h * ratios[pick(10)], pick(2) == 0, pick(5) == 0});
      c.order.insert(c.order.begin() + static_cast<std::ptrdiff_t>(pick(static_cast<int>(k) + 1)),
                     static_cast<int>(k));
      c.H = std::max(c.H, c.walkers.back().own_step);
    }
    if (pick(4) == 0) c.H *= 0.3;
    c.t_stop = c.t_start + h * (pick(2) == 0 ? 60.0 : 61.37);
    if (pick(4) == 0) c.walkers[pick(static_cast<int>(n))].finishes = c.t_start + 20.0 * h;
    follow(c);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
}

TEST(ScheduleRules, HoldForClocksThatNoRunWouldReach) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 20'000; ++i) {
    const double t_start = i % 2 ? -0.5 : 0.0, t_stop = t_start + 1.0;
    std::vector<Member> members(static_cast<std::size_t>(2 + i % 4));
    for (Member& m : members) {
      m.time = t_start + std::floor(8.0 * uniform(random)) / 8.0;
      m.next = m.time + std::floor(1.0 + 8.0 * uniform(random)) / 16.0 *
                            (1.0 + 2e-16 * std::floor(3.0 * uniform(random)));
      m.lands = uniform(random) < 0.5;
      if (m.lands) m.next = std::min(m.next, t_stop);
      m.one_step = uniform(random) < 0.2;
    }
    std::vector<int> order(members.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<int>(k);
    std::shuffle(order.begin(), order.end(), random);
    Rules rules{{}, t_start, t_stop, 0.3};
    for (const int k : order) rules.clocks.push_back(members[static_cast<std::size_t>(k)]);
    const auto standing = [&](Kind kind) {
      Schedule schedule({kind, order, {t_start, t_stop}, 0.3}, members, test::all_read_all(members.size()));
      for (std::size_t k = 0; k < members.size(); ++k)
        schedule.stand(static_cast<int>(k), members[k].time, members[k].next);
      return schedule;
    };
    Schedule turns = standing(Kind::slowest_first), parallel = standing(Kind::parallel);
    expect_turn(turns.next_round(), order, rules.in_turn(), t_stop);
    expect_round(parallel.next_round(), order, rules);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
}

}  // namespace
}  // namespace tandem
