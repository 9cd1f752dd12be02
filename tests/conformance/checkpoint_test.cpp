// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A run that is cut between any two rounds and goes on in another one, from bytes, is the whole run to the
// last bit.
#include <gtest/gtest.h>

#include <limits>

#include "cut_run.hpp"
#include "mass_pair.hpp"
#include "refusal.hpp"

namespace tandem::test {
namespace {

void expect_cuts_change_nothing(const MassPair& what) {
  const auto expected = MassPairRun(what).run();
  int rounds = 0;
  {
    MassPairRun run(what);
    Coordinator& whole = run.bench().make(what.t_stop, what.t_start);
    whole.initialize();
    while (whole.round()) ++rounds;
  }
  for (int cut = 0; cut <= rounds; ++cut) {
    MassPairRun before(what), after(what);
    const auto rows = cut_after(cut, before.bench(), after.bench(), {what.t_start, what.t_stop});
    ASSERT_TRUE(same_bits(rows, expected))
        << what.scheme.name() << ", ratio " << what.frequency_ratio << ", cut after round " << cut;
  }
}

TEST(Checkpoint, ForEveryScheduleAndReconstruction) {
  for (const Scheme& scheme : all_schemes())
    for (const double ratio : {7.0, 30.7})
      expect_cuts_change_nothing({.scheme = scheme, .frequency_ratio = ratio, .t_stop = 1.03});
}

TEST(Checkpoint, AfterEachKindOfStartAndFromAnyTime) {
  for (const StartKind start : {StartKind::derivatives, StartKind::repeat, StartKind::cold})
    for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
      for (const char* how : {"lagrange3", "hermite", "least_squares2_4"})
        expect_cuts_change_nothing({.scheme = {schedule, how, how},
                                    .frequency_ratio = 7.0,
                                    .t_start = -7.3,
                                    .t_stop = -6.1,
                                    .start = start});
}

TEST(Checkpoint, WithAMemoryOrADelay) {
  for (const Lag lag : {Lag::memory, Lag::delay})
    for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
      for (const char* how : {"lagrange0", "lagrange3", "hermite", "least_squares2_4"})
        expect_cuts_change_nothing(
            {.scheme = {schedule, how, how}, .frequency_ratio = 7.0, .t_stop = 1.2, .lag_to_slow = lag});
}

/// Long enough for histories to have dropped rows and grown.
/// One that grows without bounds.
TEST(Checkpoint, FarIntoARun) {
  for (const char* how : {"lagrange4", "least_squares2_4"}) {
    const MassPair what{.scheme = {"slowest-first", how, how}, .frequency_ratio = 100.0, .t_stop = 200.0};
    const auto expected = MassPairRun(what).run();
    for (const int cut : {37, 150, 391}) {
      MassPairRun before(what), after(what);
      EXPECT_TRUE(same_bits(cut_after(cut, before.bench(), after.bench(), {0.0, 200.0}), expected)) << cut;
    }
  }
}

struct Saved {
  explicit Saved(MassPair what) : run(what) {
    Coordinator& coordinator = run.bench().make(what.t_stop);
    coordinator.initialize();
    for (int round = 0; round < 20; ++round) coordinator.round();
    coordinator.save(bytes);
  }
  void go_on(const MassPair& in, std::span<const std::byte> from) const {
    MassPairRun other(in);
    Coordinator& coordinator = other.bench().make(in.t_stop);
    coordinator.initialize();
    ByteReader reader(from, "file", "checkpoint");
    coordinator.restore(reader);
    reader.end();
  }
  MassPairRun run;
  ByteWriter bytes;
};

TEST(Checkpoint, WhatIsNotWholeOrOfAnotherRunIsRefused) {
  MassPair what{.scheme = {"slowest-first", "lagrange3", "lagrange3"}, .frequency_ratio = 7.0};
  const Saved saved(what);
  const auto bytes = saved.bytes.bytes();
  EXPECT_NO_THROW(saved.go_on(what, bytes));
  for (std::size_t size = 0; size < bytes.size(); size += 13)
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"follow"}, [&] {
      saved.go_on(what, bytes.first(size));
    })) << size;
  what.frequency_ratio = 8.0;
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"'slow'", "own steps of"}, [&] { saved.go_on(what, bytes); }));
}

TEST(Checkpoint, ASubsystemThatCanNotGiveItsStateIsNamed) {
  MassPair what{.scheme = {"slowest-first", "lagrange3", "lagrange3"}, .wrap = one_step_a_call};
  MassPairRun run(what);
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"'fast'", "'slow'", "serializes_state"},
                      [&] { run.bench().make(1.0).require_serializable(); }));
}

}  // namespace
}  // namespace tandem::test
