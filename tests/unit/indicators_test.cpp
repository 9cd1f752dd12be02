// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/indicators.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <map>
#include <random>

#include "run_bench.hpp"
#include "scripted.hpp"
#include "tandem/coordinator/observers.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem::test::indicators {
namespace {

/// The output is a cubic of time; what is read is written down.
class Watched : public Scripted {
 public:
  Watched(double own_step, std::array<double, 4> c, int inputs, int derivatives)
      : Scripted({"watched", ports(inputs), {{"y", "1", 1, derivatives}}, {}, {}}, own_step,
                 [this, derivatives](double t, const std::vector<double>&, double* y) {
                   y[0] = at(t);
                   if (derivatives > 0) y[1] = c_[1] + t * (2.0 * c_[2] + t * 3.0 * c_[3]);
                 }),
        c_(c) {
    instead_of_advance = [this](double t_limit, bool land, std::span<const Signal> u, Samples& y) {
      const double from = grid().time();
      for (; !y.full() && grid().fits(t_limit); put(u, y)) grid().step();
      if (land && !y.full() && grid().cuts(t_limit)) grid().cut(t_limit), put(u, y);
      for (const auto& [k, times] : looked_at_)
        for (const double t : times)
          if (t > from && t <= grid().time()) read_[k][t] = u[static_cast<std::size_t>(k)].value(t);
      return clock(Stop::limit);
    };
  }

  double at(double t) const { return c_[0] + t * (c_[1] + t * (c_[2] + t * c_[3])); }
  void look(int input, double t) { looked_at_[input].push_back(t); }
  const std::map<double, double>& read(int input) { return read_[input]; }

 private:
  static std::vector<Port> ports(int inputs) {
    std::vector<Port> all;
    for (int k = 0; k < inputs; ++k) all.push_back({"u" + std::to_string(k), "1"});
    return all;
  }
  std::array<double, 4> c_;
  std::map<int, std::vector<double>> looked_at_;
  std::map<int, std::map<double, double>> read_;
};

struct Wire {
  int from, to, input;
  std::string how;
};

/// Two to four subsystems that read each other by chance.
class RandomRun {
 public:
  /// sums: all that a subsystem reads goes to one input.
  explicit RandomRun(unsigned seed, int derivatives = 1, bool sums = false) : random_(seed) {
    const int size = 2 + pick(3);
    schedule_ = std::vector<std::string>{"slowest-first", "fastest-first",
                                         "parallel"}[static_cast<std::size_t>(pick(3))];
    bench.schedule(schedule_);
    t_start = pick(3) == 0 ? 3.7 : 0.0;
    std::vector<int> inputs(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i)
      for (int k = 0; k < 2; ++k)
        if (const int from = pick(size); from != i && (k == 0 || pick(2) == 0))
          wires.push_back({from, i, inputs[static_cast<std::size_t>(i)]++, how()});
    for (int i = 0; i < size; ++i) {
      steps.push_back(std::vector{0.1, 0.01, 0.025, 0.0317}[static_cast<std::size_t>(pick(4))]);
      const int count = inputs[static_cast<std::size_t>(i)];
      parts.emplace_back(steps.back(), std::array{number(), number(), number(), number()},
                         sums ? std::min(count, 1) : count, derivatives);
      bench.add(name(i), parts.back());
    }
    for (const Wire& w : wires)
      bench.topology.connect({.from = name(w.from) + ".y",
                              .to = name(w.to) + ".u" + std::to_string(sums ? 0 : w.input),
                              .how = Reconstruction::parse(w.how),
                              .add = sums});
    bench.coordination.start = StartKind::cold;
  }

  static std::string name(int i) { return std::string(1, static_cast<char>('a' + i)); }
  double stop() const { return t_start + 2.0; }

  std::vector<double> steps;
  std::vector<Wire> wires;
  std::deque<Watched> parts;
  RunBench bench;
  double t_start;

 private:
  int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  double number() { return std::uniform_real_distribution(-1.0, 1.0)(random_); }
  std::string how() {
    static const std::vector<std::string> all{"lagrange0", "lagrange1",        "lagrange2",   "lagrange3",
                                              "hermite",   "least_squares1_2", "matched_hold"};
    const int count = static_cast<int>(all.size()) - (schedule_ == "parallel" ? 1 : 0);
    return all[static_cast<std::size_t>(pick(count))];
  }
  std::mt19937 random_;
  std::string schedule_;
};

/// Middles of the steps of the one with the shorter ones.
void look(RandomRun& run, const Wire& w) {
  const double h =
      std::min(run.steps[static_cast<std::size_t>(w.from)], run.steps[static_cast<std::size_t>(w.to)]);
  const auto node = [&](int k) { return run.t_start + k * h; };
  for (int k = 1; node(k) <= run.stop() + 1e-9; ++k)
    run.parts[static_cast<std::size_t>(w.to)].look(w.input, node(k - 1) + 0.5 * (node(k) - node(k - 1)));
}

TEST(Indicators, DefectIsWhatWasReadLessWhatTheSourceGave) {
  int some = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    RandomRun run(seed);
    for (const Wire& w : run.wires) look(run, w);
    Coordinator& coordinator = run.bench.make(run.stop(), run.t_start);
    Indicators indicators(coordinator, {});
    coordinator.observe(&indicators);
    coordinator.run();
    ASSERT_EQ(indicators.connections().size(), run.wires.size());
    for (std::size_t k = 0; k < run.wires.size(); ++k) {
      const Wire& w = run.wires[k];
      Watched& source = run.parts[static_cast<std::size_t>(w.from)];
      const double end = std::min(coordinator.time(w.from), coordinator.time(w.to));
      double largest = 0.0;
      for (const auto& [t, u] : run.parts[static_cast<std::size_t>(w.to)].read(w.input))
        if (t < end) largest = std::max(largest, std::abs(u - source.at(t)));
      some += largest > 1e-6;
      EXPECT_NEAR(indicators.connections()[k].largest, largest, 1e-12)
          << "seed " << seed << ", " << RandomRun::name(w.from) << " to " << RandomRun::name(w.to) << " "
          << w.how;
      const auto& windows = indicators.connections()[k].windows;
      EXPECT_EQ(*std::max_element(windows.begin(), windows.end()), indicators.connections()[k].largest);
    }
  }
  EXPECT_GT(some, 500) << "most have a defect";
}

/// Without derivatives a cubic is known from the fourth row on.
TEST(Indicators, WithoutDerivativesAnOutputIsCubicThroughItsNewestRows) {
  Watched slow(0.1, {0.0, 1.0, 2.0, 3.0}, 0, 0), fast(0.01, {0.0, 0.0, 0.0, 0.0}, 1, 0);
  RunBench bench;
  bench.add("slow", slow).add("fast", fast).connect("slow.y", "fast.u0", "lagrange1");
  for (int k = 1; k <= 200; ++k) fast.look(0, (k - 0.5) * 0.01);
  Coordinator& run = bench.make(2.0);
  Indicators indicators(run, {});
  run.observe(&indicators);
  run.run();
  const auto& windows = indicators.connections().at(0).windows;
  ASSERT_EQ(windows.size(), 20U);
  for (std::size_t w = 3; w < 20; ++w) {
    double largest = 0.0;
    for (const auto& [t, u] : fast.read(0))
      if (t > 0.1 * static_cast<double>(w) && t < 0.1 * static_cast<double>(w + 1))
        largest = std::max(largest, std::abs(u - slow.at(t)));
    EXPECT_NEAR(windows[w], largest, 1e-12) << w;
    EXPECT_GT(largest, 1e-3);
  }
}

/// Outputs do not depend on inputs here, so that terms of a sum are read as they would be alone.
TEST(Indicators, TermsOfASumHaveTheDefectsThatTheyHaveAlone) {
  int some = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    RandomRun apart(seed), summed(seed, 1, true);
    std::vector<Indicators::Connection> of_each[2];
    for (RandomRun* one : {&apart, &summed}) {
      Coordinator& run = one->bench.make(one->stop(), one->t_start);
      Indicators indicators(run, {});
      run.observe(&indicators);
      run.run();
      of_each[one == &summed] = indicators.connections();
    }
    ASSERT_EQ(of_each[0].size(), of_each[1].size());
    for (std::size_t k = 0; k < of_each[0].size(); ++k) {
      const auto &alone = of_each[0][k], &term = of_each[1][k];
      EXPECT_EQ(alone.windows, term.windows) << "seed " << seed << ", " << term.name;
      EXPECT_EQ(alone.peak, term.peak) << seed;
      some += term.name.find(":") != std::string::npos && term.largest > 1e-6;
    }
  }
  EXPECT_GT(some, 50) << "are terms with a defect";
}

/// Its output jumps at an event, at which a leader that has passed it stands again.
struct Kick {
  SubsystemInfo info() const { return {"kick", {}, {{"y", "1", 1, 1}}, {}, {.events = true}}; }
  double own_step() const { return h; }
  void start(double t, std::span<const double>) { time = t, height = 0.0; }
  bool step_to_event(OwnStep& s, std::span<const Signal>) {
    const bool kicks = s.begin < at && at <= s.end;
    if (kicks) s.end = at;
    time = s.end, height = time < at ? 0.0 : 0.3;
    return kicks;
  }
  void outputs_before(double* y) const { y[0] = time * time, y[1] = 2.0 * time; }
  void outputs(double* y) const { y[0] = time * time + height, y[1] = 2.0 * time; }

  double h, at, time = 0.0, height = 0.0;
};

/// A Watched that can stand again where its state was saved.
struct Returning : Watched {
  explicit Returning(double h) : Watched(h, {0.0, 0.0, 0.0, 0.0}, 1, 1) {}
  const SubsystemInfo& info() const override { return able; }
  StateId save_state() override { return saved.push_back(grid()), static_cast<StateId>(saved.size()) - 1; }
  Clock restore_state(StateId id) override {
    ++returns, grid() = saved[static_cast<std::size_t>(id)];
    return clock(Stop::limit);
  }
  void release_state(StateId) override {}

  SubsystemInfo able = with_abilities(Watched::info());
  std::vector<TimeGrid> saved;
  int returns = 0;

 private:
  static SubsystemInfo with_abilities(SubsystemInfo info) {
    return info.abilities.lands = info.abilities.saves_state = true, info;
  }
};

TEST(Indicators, WhatCountsIsWhatWasReadAfterGoingBack) {
  for (const std::string schedule : {"slowest-first", "fastest-first"})
    for (const double at : {0.537, 0.52, 0.5999, 0.500001}) {
      const bool slow_leads = schedule == "slowest-first";
      Returning leader(slow_leads ? 0.1 : 0.01);
      FixedStep kick(Kick{.h = slow_leads ? 0.01 : 0.1, .at = at});
      RunBench bench;
      bench.add("leader", leader).add("kick", kick).connect("kick.y", "leader.u0", "lagrange1");
      for (int k = 1; k <= 100; ++k) leader.look(0, (k - 0.5) * 0.01);
      Coordinator& run = bench.schedule(schedule).make(1.0);
      Indicators indicators(run, {});
      run.observe(&indicators);
      run.run();
      EXPECT_EQ(leader.returns, 1) << at;
      double largest = 0.0;
      for (const auto& [t, u] : leader.read(0))
        largest = std::max(largest, std::abs(u - t * t - (t > at ? 0.3 : 0.0)));
      EXPECT_NEAR(indicators.connections().at(0).largest, largest, 1e-12) << schedule << ' ' << at;
      EXPECT_LT(largest, 0.25) << "what it had read beyond the event is off by 0.3";
    }
}

TEST(Indicators, GoOnFromACheckpointWithTheSameBits) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    RandomRun whole(seed);
    Coordinator& run = whole.bench.make(whole.stop(), whole.t_start);
    Indicators first(run, {}), second(run, {});
    Observers both;
    both.add(first);
    run.observe(&both);
    run.initialize();
    for (unsigned round = 0; round < seed % 10 && run.round(); ++round) {
    }
    ByteWriter bytes;
    first.save(bytes);
    ByteReader from(bytes.bytes(), "run", "checkpoint of");
    second.resume(from);
    from.end();
    both.add(second);
    while (run.round()) {
    }
    for (std::size_t k = 0; k < first.connections().size(); ++k) {
      EXPECT_EQ(first.connections()[k].windows, second.connections()[k].windows) << seed;
      EXPECT_EQ(first.connections()[k].at, second.connections()[k].at) << seed;
      EXPECT_EQ(first.connections()[k].peak, second.connections()[k].peak) << seed;
    }
  }
}

}  // namespace
}  // namespace tandem::test::indicators
