// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/thread_pool.hpp"

#include <gtest/gtest.h>

#include <barrier>
#include <chrono>
#include <random>

namespace tandem {
namespace {

/// Counts how often each piece was made, and by whom the last time.
struct Counted {
  explicit Counted(int threads, int pieces)
      : times(static_cast<std::size_t>(pieces)), by(times.size()), pool(threads, pieces, [this](int piece) {
          ++times[static_cast<std::size_t>(piece)];
          by[static_cast<std::size_t>(piece)] = std::this_thread::get_id();
        }) {}
  void round(int pieces) {
    for (int k = 0; k < pieces; ++k) pool.offer(k);
    for (int k = 0; k < pieces; ++k) pool.finish(k);
  }
  std::vector<int> times;
  std::vector<std::thread::id> by;
  ThreadPool pool;
};

TEST(ThreadPool, MakesEachPieceOnceARound) {
  std::mt19937 random(20261125);
  for (const int threads : {2, 3, 4}) {
    Counted counted(threads, 37);
    std::vector<int> expected(37);
    for (int round = 0; round < 2000; ++round) {
      const int pieces = static_cast<int>(random() % 38);
      for (int k = 0; k < pieces; ++k) ++expected[static_cast<std::size_t>(k)];
      counted.round(pieces);
      ASSERT_EQ(counted.times, expected) << threads << " threads, round " << round;
    }
  }
}

TEST(ThreadPool, APieceThatStandsAloneStaysWithItsThread) {
  Counted counted(4, 3);
  for (int round = 0; round < 200; ++round) {
    counted.round(1);
    ASSERT_EQ(counted.by[0], std::this_thread::get_id());
  }
}

/// Neither of two pieces ends before the other has begun.
TEST(ThreadPool, TwoPiecesAreMadeAtOnceAlsoAfterASleep) {
  std::barrier both(2);
  ThreadPool pool(2, 2, [&both](int) { both.arrive_and_wait(); });
  for (int round = 0; round < 20; ++round) {
    if (round % 10 == 9) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    pool.offer(0);
    pool.offer(1);
    pool.finish(1);
    pool.finish(0);
  }
}

TEST(ThreadPool, WhatItsThreadsWroteIsThereAndManyPoolsComeAndGo) {
  for (int k = 0; k < 100; ++k) {
    std::vector<double> written(8);
    ThreadPool pool(3, 8, [&written](int piece) { written[static_cast<std::size_t>(piece)] += piece + 1.0; });
    for (int piece = 7; piece >= 0; --piece) pool.offer(piece);
    for (int piece = 7; piece >= 0; --piece) {
      pool.finish(piece);
      ASSERT_EQ(written[static_cast<std::size_t>(piece)], piece + 1.0);
    }
  }
}

}  // namespace
}  // namespace tandem
