// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Servers that take their time work at the same time.
#include <gtest/gtest.h>

#include <mutex>

#include "adapters.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "served.hpp"
#include "tandem/error.hpp"

namespace tandem::test {
namespace {

using Stopwatch = std::chrono::steady_clock;

/// When servers were at work, and how many at once.
class Work {
 public:
  void begin() {
    const std::lock_guard lock(mutex_);
    most = std::max(most, ++now_);
    ++calls;
  }
  void end() {
    const std::lock_guard lock(mutex_);
    --now_;
  }
  int most = 0, calls = 0;

 private:
  std::mutex mutex_;
  int now_ = 0;
};

/// Takes 20 ms for each call.
class Slow final : public Adapter {
 public:
  Slow(std::unique_ptr<Subsystem> inner, Work& work) : Adapter(std::move(inner)), work_(work) {}
  tandem::Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    work_.begin();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    work_.end();
    return inner_->advance(t_limit, land, u, y);
  }

 private:
  Work& work_;
};

wire::MakeSubsystem slowly(const std::string& uri, Work& work) {
  return [uri, &work](const std::string& p) { return std::make_unique<Slow>(source(uri)(p), work); };
}

/// The sum of the times of both would be 40 ms a round: at least 20 ms are saved in each.
TEST(Together, InParallelAllRequestsAreOnTheirWayBeforeTheFirstReplyIsAwaited) {
  Work work;
  const Served fast(listen("tcp://127.0.0.1:0", {}), slowly("builtin:two_mass.fast?frequency_ratio=2", work));
  const Served slow(listen("tcp://127.0.0.1:0", {}), slowly("builtin:two_mass.slow?frequency_ratio=2", work));
  const auto a = open(fast.address(), all_sources()), b = open(slow.address(), all_sources());
  RunBench bench;
  bench.add("fast", *a).add("slow", *b).schedule("parallel");
  bench.connect("slow.x2", "fast.x2").connect("fast.x1", "slow.x1");
  bench.run(0.2);
  EXPECT_EQ(work.calls, 20) << "10 rounds of both";
  EXPECT_EQ(work.most, 2);
}

/// One leads; two follow it at the same pace and do not read each other.
RunBench& star(RunBench& bench, const std::vector<std::unique_ptr<Subsystem>>& three,
               const std::string& schedule) {
  bench.add("slow", *three[0]).add("a", *three[1]).add("b", *three[2]).schedule(schedule);
  bench.connect("slow.x2", "a.x2", "lagrange2").connect("slow.x2", "b.x2", "lagrange2");
  bench.connect("a.x1", "slow.x1", "lagrange2");
  return bench;
}

TEST(Together, InTurnsThoseThatDoNotReadEachOtherWorkAtTheSameTime) {
  for (const std::string schedule : {"slowest-first", "fastest-first"}) {
    Work work;
    const Served fast(listen("tcp://127.0.0.1:0", {}),
                      slowly("builtin:two_mass.fast?frequency_ratio=3", work));
    std::vector<std::unique_ptr<Subsystem>> remote, local;
    remote.push_back(open("builtin:two_mass.slow?frequency_ratio=3", all_sources()));
    local.push_back(open("builtin:two_mass.slow?frequency_ratio=3", all_sources()));
    for (int k = 0; k < 2; ++k) {
      remote.push_back(open(fast.address(), all_sources()));
      local.push_back(open("builtin:two_mass.fast?frequency_ratio=3", all_sources()));
    }
    RunBench over_sockets, in_one_process;
    star(over_sockets, remote, schedule).run(0.15);
    star(in_one_process, local, schedule).run(0.15);
    EXPECT_TRUE(same_bits(over_sockets.recording.all(), in_one_process.recording.all())) << schedule;
    EXPECT_EQ(work.most, 2) << schedule;
  }
}

TEST(Together, WhatTheOthersGaveIsKeptWhenOneFails) {
  class Failing final : public Adapter {
   public:
    using Adapter::Adapter;
    tandem::Clock advance(double, bool, std::span<const Signal>, Samples&) override {
      throw Error(ErrorCode::numerical, "no convergence");
    }
  };
  const Served fast(listen("tcp://127.0.0.1:0", {}), source("builtin:two_mass.fast?frequency_ratio=2"));
  Failing slow(open("builtin:two_mass.slow?frequency_ratio=2", all_sources()));
  const auto a = open(fast.address(), all_sources());
  RunBench bench;
  bench.add("fast", *a).add("slow", slow).schedule("parallel");
  bench.connect("slow.x2", "fast.x2").connect("fast.x1", "slow.x1");
  bench.coordination.start = StartKind::cold;
  Coordinator& run = bench.make(1.0);
  run.observe(&bench.recording);
  run.initialize();
  EXPECT_THROW(run.round(), Error);
  EXPECT_EQ(bench.recording.rows(0).back()[0], 0.02) << "the fast side has gone to the end of the round";
}

}  // namespace
}  // namespace tandem::test
