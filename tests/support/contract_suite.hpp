// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What every Subsystem has to do. To put one to the test, in one source file of a test program:
//   INSTANTIATE_TEST_SUITE_P(Mine, SubsystemContract, testing::Values(ContractCase{"mine", [] { return
//   make(); }}), contract_name);
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "refusal.hpp"
#include "same_bits.hpp"
#include "tandem/coordinator/topology.hpp"
#include "tandem/time_grid.hpp"
#include "word.hpp"

namespace tandem::test {

struct ContractCase {
  std::string name;
  std::function<std::unique_ptr<Subsystem>()> make;
  double t_start = 0.0;
};
inline std::string contract_name(const testing::TestParamInfo<ContractCase>& p) { return word(p.param.name); }
inline void PrintTo(const ContractCase& c, std::ostream* out) { *out << c.name; }

/// One instance, driven call by call, with all the rows that it gave. Input k is a parabola over a span, a
/// cubic after it.
class ContractRun {
 public:
  explicit ContractRun(const ContractCase& what) : subsystem(what.make()), t_start_(what.t_start) {
    const auto inputs = static_cast<std::size_t>(subsystem->info().input_size());
    for (std::size_t k = 0; k < inputs; ++k) {
      const double a = 1.0 + 0.25 * static_cast<double>(k), t = t_start_;
      pieces_.push_back({{t + 0.13, t, {a, 0.5, -1.0, 0.0}},
                         {t + 0.31, t, {a, 0.4, -0.5, 0.3}},
                         {t + 0.5, t, {a, 0.3, 0.2, -0.1}}});
    }
    for (std::size_t k = 0; k < inputs; ++k)
      signals_.emplace_back(pieces_[k].data(), 3, 3), u0_.push_back(pieces_[k][0].c[0]);
    initialize(u0_);
  }

  /// Starts, with a new list of rows.
  Clock initialize(const std::vector<double>& u0) {
    rows.clear();
    return clock =
               call(1, [&](Samples& y) { return subsystem->initialize(t_start_, t_start_ + 1e6, u0, y); });
  }
  Clock initialize() { return initialize(u0_); }

  /// One call with that much room.
  Clock advance(double t_limit, bool land = false, std::int64_t room = 10'000) {
    return clock = call(room, [&](Samples& y) { return subsystem->advance(t_limit, land, signals_, y); });
  }
  /// As many calls as it takes to get there, each with that much room.
  void go_to(double t_limit, bool land = false, std::int64_t room = 10'000) {
    const TimeTolerance tolerance(t_start_);
    for (int calls = 0;
         !tolerance.before(t_limit, clock.next_time) || (land && tolerance.before(clock.time, t_limit));
         ++calls) {
      ASSERT_LT(calls, 100'000) << "no end at t = " << clock.time;
      advance(t_limit, land, room);
    }
  }
  double step() const { return clock.next_time - clock.time; }

  std::unique_ptr<Subsystem> subsystem;
  Clock clock{};
  Recording::Rows rows;

 private:
  static constexpr double untouched = 6.02214076e23;

  template <class Call>
  Clock call(std::int64_t room, const Call& make) {
    const std::int64_t stride = subsystem->info().row_size();
    const std::int64_t first = rows.empty() ? 0 : 1;  // rows of earlier calls may stand before
    std::vector<double> memory(static_cast<std::size_t>((room + first + 1) * stride), untouched);
    Samples y(memory.data(), stride, room + first, first);
    const Clock result = make(y);
    EXPECT_GE(y.size(), first);
    EXPECT_LE(y.size(), room + first);
    for (std::int64_t k = 0; k < static_cast<std::int64_t>(memory.size()); ++k)
      if ((k < first * stride || k >= y.size() * stride) && memory[static_cast<std::size_t>(k)] != untouched)
        ADD_FAILURE() << "wrote outside the rows that it appended";
    for (std::int64_t row = first; row < y.size(); ++row)
      rows.emplace_back(memory.begin() + row * stride, memory.begin() + (row + 1) * stride);
    EXPECT_EQ(result.time, rows.empty() ? result.time : rows.back()[0])
        << "the clock stands at the newest sample";
    EXPECT_TRUE(result.stop == Stop::finished || result.next_time > result.time);
    return result;
  }

  double t_start_;
  std::vector<std::vector<Segment>> pieces_;
  std::vector<Signal> signals_;
  std::vector<double> u0_;
};

class SubsystemContract : public testing::TestWithParam<ContractCase> {
 protected:
  const Abilities& can() const { return run.subsystem->info().abilities; }
  /// A time some steps ahead that is no node.
  double ahead(double steps) const { return run.clock.time + steps * run.step(); }
  /// All rows up to t in one call.
  Recording::Rows in_one_call(double t, bool land = false) const {
    ContractRun other(GetParam());
    other.advance(t, land);
    return other.rows;
  }
  static testing::AssertionResult same(const Recording::Rows& a, const Recording::Rows& b) {
    return same_bits({a}, {b});
  }

  ContractRun run{GetParam()};
};

TEST_P(SubsystemContract, ItsPortsMakeSense) {
  Topology topology;
  EXPECT_NO_THROW(topology.add("it", run.subsystem->info()));
  EXPECT_FALSE(run.subsystem->info().name.empty());
}

TEST_P(SubsystemContract, ItsInfoIsConstant) {
  const SubsystemInfo before = run.subsystem->info();
  run.advance(ahead(2.5));
  const SubsystemInfo& after = run.subsystem->info();
  EXPECT_EQ(after.name, before.name);
  EXPECT_EQ(after.row_size(), before.row_size());
  EXPECT_EQ(after.input_size(), before.input_size());
  EXPECT_EQ(after.feedthrough.size(), before.feedthrough.size());
}

TEST_P(SubsystemContract, TheStartIsOneSampleAtTStart) {
  ASSERT_EQ(run.rows.size(), 1U);
  EXPECT_EQ(run.rows[0][0], GetParam().t_start);
  EXPECT_EQ(run.clock.time, GetParam().t_start);
  for (const double v : run.rows[0]) EXPECT_TRUE(std::isfinite(v));
}

TEST_P(SubsystemContract, WhatNoUnknownInputFeedsThroughToIsFiniteAtTheStart) {
  const SubsystemInfo& info = run.subsystem->info();
  run.initialize(std::vector<double>(static_cast<std::size_t>(info.input_size()),
                                     std::numeric_limits<double>::quiet_NaN()));
  for (int k = 0; k < info.output_size(); ++k) {
    bool fed = false;
    for (const Feedthrough& f : info.feedthrough) fed |= f.output == k;
    EXPECT_TRUE(fed || std::isfinite(run.rows[0][static_cast<std::size_t>(Samples::header + k)]))
        << "output " << k;
  }
}

TEST_P(SubsystemContract, StartingAgainBeforeTheFirstAdvanceGivesTheSameBits) {
  const double end = ahead(7.5);
  run.initialize();
  run.initialize();
  run.advance(end);
  EXPECT_TRUE(same(run.rows, in_one_call(end)));
}

TEST_P(SubsystemContract, StartingAgainAfterAnAdvanceGivesTheSameBits) {
  if (!can().restarts) GTEST_SKIP() << "it does not restart";
  const double end = ahead(7.5);
  run.advance(end);
  run.initialize();
  run.advance(end);
  EXPECT_TRUE(same(run.rows, in_one_call(end)));
}

TEST_P(SubsystemContract, AdvanceTakesAllTheStepsThatFitAndNoOther) {
  for (const double steps : {0.5, 1.5, 3.25, 10.0}) {
    const double limit = ahead(steps);
    run.go_to(limit);
    const TimeTolerance tolerance(GetParam().t_start);
    EXPECT_FALSE(tolerance.before(limit, run.clock.time)) << "past the limit";
    EXPECT_TRUE(tolerance.before(limit, run.clock.next_time)) << "another step fits";
    EXPECT_EQ(run.clock.stop, Stop::limit);
  }
}

TEST_P(SubsystemContract, AStepThatDoesNotFitIsNotTaken) {
  const Clock before = run.clock;
  run.advance(ahead(0.5));
  EXPECT_EQ(run.rows.size(), 1U);
  EXPECT_EQ(run.clock.time, before.time);
  EXPECT_EQ(run.clock.next_time, before.next_time);
}

TEST_P(SubsystemContract, EachStepGivesOneSampleAndOneByOneTheyAreTheSame) {
  const double end = ahead(23.5);
  for (int count = 2; run.clock.next_time < end; ++count) {
    run.advance(run.clock.next_time);
    ASSERT_EQ(run.rows.size(), static_cast<std::size_t>(count));
  }
  EXPECT_TRUE(same(run.rows, in_one_call(end)));
}

TEST_P(SubsystemContract, TimesRise) {
  run.advance(ahead(100.5));
  for (std::size_t k = 1; k < run.rows.size(); ++k)
    EXPECT_TRUE(run.rows[k][0] > run.rows[k - 1][0] ||
                (run.rows[k][1] == 1.0 && run.rows[k][0] == run.rows[k - 1][0]));
}

TEST_P(SubsystemContract, ItReturnsEarlyWithoutRoomAndGoesOnWithTheSameBits) {
  const double end = ahead(20.5);
  run.advance(end, false, 2);
  EXPECT_EQ(run.clock.stop, Stop::samples_full);
  EXPECT_EQ(run.rows.size(), 3U);
  for (const std::int64_t room : {1, 2, 3, 7}) {
    ContractRun other(GetParam());
    other.go_to(end, false, room);
    EXPECT_TRUE(same(other.rows, in_one_call(end))) << room;
  }
}

TEST_P(SubsystemContract, ItLandsExactlyAndKeepsItsGrid) {
  if (!can().lands) GTEST_SKIP() << "it can't cut a step";
  const double limit = ahead(4.37), node = in_one_call(ahead(5.5)).back()[0];
  run.go_to(limit, true);
  EXPECT_EQ(run.clock.time, limit);
  if (can().chooses_step) return;
  EXPECT_EQ(run.clock.next_time, node);
  run.advance(node);
  EXPECT_EQ(run.clock.time, node);
  const Clock grid = run.clock;
  run.advance(ahead(1.0), true);  // a limit on a node: nothing to cut
  EXPECT_EQ(run.clock.time, grid.next_time);
}

TEST_P(SubsystemContract, LandingReturnsEarlyWithoutRoomToo) {
  if (!can().lands) GTEST_SKIP() << "it can't cut a step";
  const double limit = ahead(4.37);
  run.go_to(limit, true, 1);
  EXPECT_TRUE(same(run.rows, in_one_call(limit, true)));
}

TEST_P(SubsystemContract, ARestoredStateGoesOnWithTheSameBits) {
  Subsystem& s = *run.subsystem;
  if (!can().saves_state) {
    EXPECT_TRUE(refuses(ErrorCode::not_supported, {}, [&] { s.save_state(); }));
    EXPECT_TRUE(refuses(ErrorCode::not_supported, {}, [&] { s.restore_state(0); }));
    EXPECT_TRUE(refuses(ErrorCode::not_supported, {}, [&] { s.release_state(0); }));
    return;
  }
  run.advance(ahead(3.5));
  const Clock saved_at = run.clock;
  const StateId first = s.save_state();
  const double end = ahead(9.37);
  run.advance(end, can().lands);
  const Recording::Rows expected = run.rows;
  const StateId second = s.save_state();
  for (int again = 0; again < 2; ++again) {
    run.clock = s.restore_state(first);
    EXPECT_EQ(run.clock.time, saved_at.time);
    EXPECT_EQ(run.clock.next_time, saved_at.next_time);
    run.rows.resize(4);
    run.advance(end, can().lands);
    EXPECT_TRUE(same(run.rows, expected));
  }
  s.release_state(first);
  EXPECT_EQ(s.restore_state(second).time, expected.back()[0]) << "the other state is still there";
  s.release_state(second);
}

TEST_P(SubsystemContract, AStateThatIsReleasedOrWasNeverSavedIsRefused) {
  if (!can().saves_state) GTEST_SKIP() << "it saves no state";
  Subsystem& s = *run.subsystem;
  const StateId id = s.save_state();
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {}, [&] { s.restore_state(id + 1); }));
  s.release_state(id);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {}, [&] { s.restore_state(id); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {}, [&] { s.release_state(id); }));
}

TEST_P(SubsystemContract, InstancesAreIndependent) {
  ContractRun other(GetParam());
  const double end = ahead(12.5);
  while (run.clock.next_time < end) {
    run.advance(run.clock.next_time);
    other.advance(other.clock.next_time);
  }
  EXPECT_TRUE(same(run.rows, in_one_call(end)));
  EXPECT_TRUE(same(other.rows, run.rows));
}

TEST_P(SubsystemContract, AnInstanceMayBeDroppedBeforeItIsStarted) { EXPECT_NE(GetParam().make(), nullptr); }

}  // namespace tandem::test
