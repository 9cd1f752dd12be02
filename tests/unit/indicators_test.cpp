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
    instead_of_advance = [this](double t_limit, bool, std::span<const Signal> u, Samples& y) {
      const double from = grid().time();
      for (; !y.full() && grid().fits(t_limit); put(u, y)) grid().step();
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
  explicit RandomRun(unsigned seed, int derivatives = 1) : random_(seed) {
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
      parts.emplace_back(steps.back(), std::array{number(), number(), number(), number()},
                         inputs[static_cast<std::size_t>(i)], derivatives);
      bench.add(name(i), parts.back());
    }
    for (const Wire& w : wires)
      bench.connect(name(w.from) + ".y", name(w.to) + ".u" + std::to_string(w.input), w.how);
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
