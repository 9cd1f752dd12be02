// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Whatever goes first, and however far a turn reaches: each own step sees the same samples.
#include "tandem/coordinator/turn_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

#include "schedule_bench.hpp"

namespace tandem::test {
namespace {

/// By subsystem and own step: how many own steps of each other one it could see; for a leader up to the first
/// at or past the end of the step, as it interpolates. -1: not linked.
using Seen = std::map<std::pair<int, int>, std::vector<int>>;

struct System {
  std::vector<double> steps;
  std::vector<int> order;
  std::vector<Read> reads;
  double t_stop = 60.0;

  int size() const { return static_cast<int>(steps.size()); }
  double node(int who, int k) const { return k * steps[static_cast<std::size_t>(who)]; }
  bool linked(int a, int b) const {
    return std::any_of(reads.begin(), reads.end(), [&](const Read& r) {
      return (r.reader == a && r.source == b) || (r.reader == b && r.source == a);
    });
  }
  bool leads(int a, int b) const {
    return std::find(order.begin(), order.end(), a) < std::find(order.begin(), order.end(), b);
  }
  bool before(double a, double b) const { return TimeTolerance().before(a, b); }
  std::vector<int> seen_by(int who, int step, const std::vector<int>& taken) const {
    std::vector<int> all(steps.size(), -1);
    for (int j = 0; j < size(); ++j)
      if (j != who && linked(who, j)) {
        int& k = all[static_cast<std::size_t>(j)] = taken[static_cast<std::size_t>(j)];
        while (k > 0 && !before(node(j, k - 1), node(who, step))) --k;
      }
    return all;
  }
};

/// The rules of TurnOrder, one own step at a time, of those that may go any one by chance.
class OneByOne {
 public:
  OneByOne(const System& system, std::mt19937_64& random)
      : s_(system), random_(random), taken_(system.steps.size()) {}

  Seen run() {
    while (true) {
      freed_.clear();
      std::vector<int> ready;
      bool all_done = true;
      for (const int i : s_.order)
        if (!done(i)) all_done = false, blocker(i) < 0 ? ready.push_back(i) : void();
      if (all_done) return seen_;
      const int who = ready.empty() ? out_of_ring() : ready[random_() % ready.size()];
      const auto k = static_cast<std::size_t>(who);
      seen_[{who, taken_[k] + 1}] = s_.seen_by(who, taken_[k] + 1, taken_);
      ++taken_[k];
    }
  }

 private:
  double time(int i) const { return s_.node(i, taken_[static_cast<std::size_t>(i)]); }
  double next(int i) const { return s_.node(i, taken_[static_cast<std::size_t>(i)] + 1); }
  bool done(int i) const { return s_.before(s_.t_stop, next(i)) || !s_.before(time(i), s_.t_stop); }

  int blocker(int i) const {
    for (const int j : s_.order) {
      if (i == j || done(j) || !s_.linked(i, j)) continue;
      if (s_.leads(j, i) ? s_.before(time(j), next(i))
                         : !s_.before(time(i), next(j)) && !freed_.contains({i, j}))
        return j;
    }
    return -1;
  }

  /// From the one with the earliest node, until the ring is closed.
  int out_of_ring() {
    int earliest = -1;
    for (const int i : s_.order)
      if (!done(i) && (earliest < 0 || next(i) < next(earliest))) earliest = i;
    while (true) {
      std::vector<int> chain{earliest};
      for (int j = blocker(earliest); j >= 0; j = blocker(j)) {
        const bool closed = std::find(chain.begin(), chain.end(), j) != chain.end();
        chain.push_back(j);
        if (!closed) continue;
        auto at = std::find(chain.begin(), chain.end(), j);
        while (s_.leads(at[1], at[0])) ++at;
        freed_[{at[0], at[1]}] = true;
        break;
      }
      if (blocker(chain.back()) < 0) return chain.back();
    }
  }

  const System& s_;
  std::mt19937_64& random_;
  std::vector<int> taken_;
  std::map<std::pair<int, int>, bool> freed_;
  Seen seen_;
};

/// In rounds of whole turns.
Seen in_rounds(const System& s, std::size_t* turns = nullptr) {
  std::vector<Member> members(s.steps.size());
  Schedule schedule({Schedule::Kind::slowest_first, s.order, {0.0, s.t_stop}, 1.0}, members, s.reads);
  std::vector<int> taken(s.steps.size());
  const auto stand = [&](int i) {
    const int k = taken[static_cast<std::size_t>(i)];
    schedule.stand(i, s.node(i, k), s.node(i, k + 1));
  };
  for (int i = 0; i < s.size(); ++i) stand(i);
  Seen seen;
  while (true) {
    const auto round = schedule.next_round();
    if (round.empty()) return seen;
    const std::vector<Turn> now(round.begin(), round.end());
    const std::vector<int> visible = taken;
    if (turns) *turns += now.size();
    for (const Turn& turn : now) {
      for (const Turn& other : now) EXPECT_FALSE(turn.who != other.who && s.linked(turn.who, other.who));
      int& k = taken[static_cast<std::size_t>(turn.who)];
      for (; !s.before(turn.limit, s.node(turn.who, k + 1)); ++k)
        seen[{turn.who, k + 1}] = s.seen_by(turn.who, k + 1, visible);
      stand(turn.who);
    }
  }
}

class TurnOrders : public testing::Test {
 protected:
  System any_of(int n) {
    System s;
    for (int i = 0; i < n; ++i)
      s.steps.push_back(random_() % 2 == 0 ? 0.5 * static_cast<double>(1 + random_() % 16)
                                           : std::uniform_real_distribution(0.5, 9.0)(random_));
    s.order.resize(static_cast<std::size_t>(n));
    std::iota(s.order.begin(), s.order.end(), 0);
    std::shuffle(s.order.begin(), s.order.end(), random_);
    if (const auto rule = random_() % 3; rule < 2)
      std::stable_sort(s.order.begin(), s.order.end(), [&](int a, int b) {
        const double ha = s.steps[static_cast<std::size_t>(a)], hb = s.steps[static_cast<std::size_t>(b)];
        return rule == 0 ? ha > hb : ha < hb;
      });
    return s;
  }
  std::mt19937_64 random_{2026};
};

TEST_F(TurnOrders, GiveEachStepTheSameSamplesWhateverGoesFirst) {
  for (int trial = 0; trial < 600; ++trial) {
    System s = any_of(2 + static_cast<int>(random_() % 6));
    const auto n = static_cast<std::uint64_t>(s.size());
    if (trial % 3 == 0) s.reads = all_read_all(n);
    for (std::uint64_t k = trial % 3 == 0 ? 2 * n : 0; k < 2 * n; ++k)
      s.reads.push_back({static_cast<int>(random_() % n), static_cast<int>(random_() % n)});
    const Seen seen = in_rounds(s);
    for (int repeated = 0; repeated < 2; ++repeated) {
      const Seen other = OneByOne(s, random_).run();
      ASSERT_EQ(other.size(), seen.size());
      for (const auto& [step, what] : seen)
        ASSERT_EQ(other.at(step), what) << trial << ": " << step.first << ' ' << step.second;
    }
  }
}

/// Of systems that are not linked each goes on as if it were alone.
TEST_F(TurnOrders, WhatIsNotLinkedChangesNothing) {
  for (int trial = 0; trial < 100; ++trial) {
    System both = any_of(6);
    for (int k = 0; k < 8; ++k) {
      const int side = 3 * static_cast<int>(random_() % 2);
      both.reads.push_back({side + static_cast<int>(random_() % 3), side + static_cast<int>(random_() % 3)});
    }
    System one = both;
    one.steps.resize(3);
    std::erase_if(one.order, [](int i) { return i >= 3; });
    std::erase_if(one.reads, [](const Read& r) { return r.reader >= 3; });
    Seen alone = in_rounds(one), together = in_rounds(both);
    std::erase_if(together, [](const auto& step) { return step.first.first >= 3; });
    for (auto& [step, seen] : together) seen.resize(3);
    ASSERT_EQ(together, alone) << trial;
  }
}

/// Fast partners that read the hub alone do not cut one another's turns; nor do pairs.
TEST_F(TurnOrders, TurnsAreLimitedOnlyByWhoReadsAndIsRead) {
  const System hub{{0.01, 1e-4 / 1.7, 1e-4}, {0, 2, 1}, {{0, 1}, {1, 0}, {0, 2}, {2, 0}}, 1.0};
  const System pairs{{0.01, 1e-4, 0.007, 1.3e-4}, {0, 2, 3, 1}, {{0, 1}, {1, 0}, {2, 3}, {3, 2}}, 1.0};
  std::size_t turns = 0;
  in_rounds(hub, &turns);
  EXPECT_EQ(turns, 300U);
  turns = 0;
  in_rounds(pairs, &turns);
  EXPECT_EQ(turns, 2U * 100U + 2U * 142U);
}

}  // namespace
}  // namespace tandem::test
