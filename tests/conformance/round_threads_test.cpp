// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Calls of one round that several threads make.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <thread>

#include "mass_pair.hpp"
#include "refusal.hpp"
#include "same_bits.hpp"
#include "scripted.hpp"

namespace tandem::test {
namespace {

/// Where two calls are made at once: each waits for another one, until two have met or one has waited in
/// vain.
class Meeting {
 public:
  void wait() {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    if (++inside_ > 1) met_ = over_ = true;
    while (!over_) {
      if (std::chrono::steady_clock::now() > until) over_ = true;
      std::this_thread::yield();
    }
    --inside_;
  }
  bool met() const { return met_; }

 private:
  std::atomic<int> inside_ = 0;
  std::atomic<bool> over_ = false, met_ = false;
};

/// Which threads made its calls. They last long enough for another thread; it may fail at a time.
class Watched final : public Adapter {
 public:
  struct Seen {
    std::set<std::thread::id> threads;
    int calls = 0;
    double fails_at = std::numeric_limits<double>::infinity();
    bool one_thread = false;
  };
  Watched(std::unique_ptr<Subsystem> inner, Seen& seen, Meeting* meeting)
      : Adapter(busy(std::move(inner))), seen_(seen), meeting_(meeting) {}
  bool one_thread() const override { return seen_.one_thread; }
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    seen_.threads.insert(std::this_thread::get_id());
    if (meeting_ && !seen_.one_thread && ++seen_.calls > 1) meeting_->wait();
    if (t_limit > seen_.fails_at) throw Error(ErrorCode::numerical, "it has had enough");
    return inner_->advance(t_limit, land, u, y);
  }

 private:
  Seen& seen_;
  Meeting* meeting_;
};

/// Pairs of two masses that have nothing to do with each other, of ratios from 3 on.
class Pairs {
 public:
  explicit Pairs(const std::string& schedule, int threads) : seen(2 * count) {
    bench.schedule(schedule);
    bench.coordination.threads = threads;
    for (std::size_t k = 0; k < count; ++k) add(k);
  }
  const std::vector<Recording::Rows>& run() { return bench.run(3.0).all(); }

  RunBench bench;
  std::vector<Watched::Seen> seen;
  Meeting meeting;

 private:
  static constexpr std::size_t count = 4;

  void add(std::size_t k) {
    two_mass::Settings settings;
    settings.frequency_ratio = 3.0 + static_cast<double>(k);
    settings.phase1 = settings.phase2 = 0.8;
    const two_mass::Model model(settings);
    const std::string fast = "fast" + std::to_string(k), slow = "slow" + std::to_string(k);
    add(fast, std::make_unique<FixedStep<two_mass::FastMass>>(two_mass::FastMass(model, {})));
    add(slow, std::make_unique<FixedStep<two_mass::SlowMass>>(two_mass::SlowMass(model, {})));
    bench.connect(slow + ".x2", fast + ".x2", "lagrange3").connect(fast + ".x1", slow + ".x1", "lagrange3");
  }
  void add(const std::string& name, std::unique_ptr<Subsystem> one) {
    Meeting* const place = bench.coordination.threads > 1 ? &meeting : nullptr;
    all_.push_back(std::make_unique<Watched>(std::move(one), seen[all_.size()], place));
    bench.add(name, *all_.back());
  }
  std::vector<std::unique_ptr<Subsystem>> all_;
};

const std::vector<std::string> schedules = {"slowest-first", "fastest-first", "parallel"};

TEST(RoundThreads, MakeCallsAtOnceAndGiveTheSameBits) {
  for (const std::string& schedule : schedules) {
    Pairs alone(schedule, 1);
    const auto expected = alone.run();
    for (const int threads : {2, 3}) {
      Pairs shared(schedule, threads);
      EXPECT_TRUE(same_bits(shared.run(), expected)) << schedule << ", " << threads << " threads";
      EXPECT_TRUE(shared.meeting.met()) << schedule << ", " << threads << " threads";
    }
  }
}

TEST(RoundThreads, GiveTheSameBitsInEverySchemeOfTwo) {
  for (const Scheme& scheme : all_schemes()) {
    MassPair what{.scheme = scheme, .frequency_ratio = 7.0, .t_stop = 0.5};
    const auto expected = MassPairRun(what).run();
    what.wrap = busy;
    MassPairRun shared(what);
    shared.bench().coordination.threads = 2;
    EXPECT_TRUE(same_bits(shared.run(), expected)) << scheme.name();
  }
}

TEST(RoundThreads, WhoIsOfOneThreadStaysThere) {
  Pairs pairs("parallel", 3);
  pairs.seen[2].one_thread = true;
  pairs.run();
  EXPECT_EQ(pairs.seen[2].threads, std::set{std::this_thread::get_id()});
  EXPECT_TRUE(pairs.meeting.met());
}

/// The error names whose it is, the first of the round, and what the others gave is kept.
TEST(RoundThreads, AnErrorIsThatOfARunInOneThread) {
  for (const std::string& schedule : schedules) {
    std::vector<std::string> sentences;
    std::vector<std::vector<Recording::Rows>> rows;
    for (const int threads : {1, 2, 3}) {
      Pairs pairs(schedule, threads);
      pairs.seen[3].fails_at = 2.0;
      try {
        pairs.run();
        ADD_FAILURE() << "no error";
      } catch (const Error& error) {
        sentences.push_back(error.what());
      }
      rows.push_back(pairs.bench.recording.all());
    }
    EXPECT_NE(sentences[0].find("'slow1', advance at t = "), std::string::npos) << sentences[0];
    EXPECT_EQ(sentences, std::vector(3, sentences[0])) << schedule;
    EXPECT_TRUE(same_bits(rows[2], rows[1])) << schedule;
  }
}

TEST(RoundThreads, FewerThanOneAreRefused) {
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"has 0 threads", "1 or more"},
                      [] { Pairs("parallel", 0).run(); }));
}

}  // namespace
}  // namespace tandem::test
