// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Runs that are made up to points of time that nobody knew when they began, on inputs that are told on the way.
#include <gtest/gtest.h>

#include <map>

#include "driven_models.hpp"
#include "mass_pair.hpp"
#include "random_scene.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/subsystem.hpp"

namespace tandem::test {
namespace {

/// One that is made up to each of the times, the last of which is where it ends.
std::vector<Recording::Rows> paused(RunBench& bench, double t_start, const std::vector<double>& times) {
  bench.coordination.pauses = true;
  Coordinator& run = bench.make(times.back(), t_start);
  run.observe(&bench.recording);
  run.initialize();
  for (const double t : times) run.run_to(t);
  return bench.recording.all();
}

TEST(Pauses, AtNodesOfAllChangeNothing) {
  for (const Scheme& scheme : all_schemes()) {
    if (scheme.schedule == "staggered")
      continue;  // has the fast side end a step at each node of the slow one
    for (const double ratio : {7.0, 30.0}) {
      MassPair what{.scheme = scheme, .frequency_ratio = ratio, .t_start = -0.5, .start = StartKind::cold};
      MassPairRun unfinished(what);
      Coordinator& run = unfinished.bench().make(what.t_stop, what.t_start);
      run.initialize();
      std::vector<double> times;
      for (int k = 1; k <= 30; ++k) times.push_back(what.t_start + k * run.own_step(1));
      what.t_stop = times.back();
      MassPairRun straight(what), pausing(what);
      const auto expected = straight.run();
      EXPECT_TRUE(same_bits(paused(pausing.bench(), what.t_start, times), expected))
          << scheme.name() << ", ratio " << ratio;
    }
  }
}

/// x' = u from a start, and what integrates y = x + u of that: steps of their own, the second one in turns.
struct OpenPair {
  OpenPair(double step, double of_reader, const std::string& schedule, double start)
      : carrier{Integral(step)}, reader{Integral(of_reader)} {
    bench.add("carrier", carrier).add("reader", reader).connect("carrier.y", "reader.u", "lagrange1");
    bench.schedule(schedule).topology.leave_open(0, 0, start);
    bench.coordination.pauses = true;
  }
  double value(int who, int output) const {
    const History& history = bench.coordinator->exchange().history(who);
    return history.row(history.newest())[Samples::header + output];
  }
  FixedStep<Integral> carrier, reader;
  RunBench bench;
};

/// What is exact of them while u = c0 + c1 (t - t0) + c2 (t - t0)^2: x, and the integral of x + u.
struct Exact {
  double x = 0.0, sum = 0.0;
  void go_on(const double* c, double h) {
    const double x_part = h * h * (c[0] / 2.0 + h * (c[1] / 6.0 + h * c[2] / 12.0)),
                 u_part = h * (c[0] + h * (c[1] / 2.0 + h * c[2] / 3.0));
    sum += h * x + x_part + u_part;
    x += u_part;
  }
};

/// At times that fit nothing, steps longer and shorter than what lies between them. The reader follows its source,
/// whose output is a straight line while the input is held.
TEST(Pauses, AnOpenInputThatIsHeldIsRightToRoundingAlsoBehindWhatFollowsItAtOnce) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> gap(0.003, 0.08), value(-1.0, 1.0);
    const double start = seed % 3 == 0 ? -41.7 : 0.0, first = value(random);
    OpenPair pair(seed % 2 ? 0.02 : 0.0131, seed % 2 ? 0.0131 : 0.02,
                  seed % 2 ? "slowest-first" : "fastest-first", first);
    Coordinator& run = pair.bench.make(start + 10.0, start);
    run.initialize();
    Exact exact;
    double t = start, u = first;
    for (int k = 0; k < 40; ++k) {
      const double next = t + gap(random), c[] = {u, 0.0, 0.0};
      const Segment piece{next, t, {u}};
      run.open_input(0, 0).go_on(t, Signal(&piece, 1, 0));
      run.tell_jumps();
      EXPECT_NEAR(pair.value(0, 1), exact.x + u, 1e-12) << "an output follows at once";
      run.run_to(next);
      exact.go_on(c, next - t);
      EXPECT_NEAR(pair.value(0, 0), exact.x, 1e-12) << seed << " t = " << next;
      EXPECT_NEAR(pair.value(1, 0), exact.sum, 1e-12) << seed << " t = " << next;
      EXPECT_EQ(run.time(0), next);
      EXPECT_EQ(run.time(1), next);
      t = next;
      if (k % 4 != 1) u = value(random);
    }
  }
}

/// Simpson's rule is right for cubics. What hangs together is no jump.
TEST(Pauses, AnOpenInputIsAnyPolynomial) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> gap(0.003, 0.08), value(-1.0, 1.0);
  FixedStep<Integral> subsystem{Integral(0.0171)};
  RunBench bench;
  bench.add("a", subsystem).topology.leave_open(0, 0, 0.0);
  bench.coordination.pauses = true;
  Coordinator& run = bench.make(10.0);
  run.observe(&bench.recording);
  run.initialize();
  Exact exact;
  double t = 0.0, u = 0.0;
  for (int k = 0; k < 100; ++k) {
    const double h = gap(random), c[] = {u, value(random), value(random)};
    const Segment piece{t + h, t, {c[0], c[1], c[2]}};
    run.open_input(0, 0).go_on(t, Signal(&piece, 1, 2));
    run.run_to(t + h);
    exact.go_on(c, h);
    t += h, u = c[0] + h * (c[1] + h * c[2]);
    const auto& row = bench.recording.rows(0).back();
    EXPECT_EQ(row[0], t);
    EXPECT_NEAR(row[2], exact.x, 1e-13);
    EXPECT_NEAR(row[3], exact.x + u, 1e-13);
  }
  for (const auto& row : bench.recording.rows(0)) EXPECT_EQ(row[1], 0.0);
}

/// A scene of diagrams, of whose inputs a quarter is open: held, and another number at each pause.
class OpenScene {
 public:
  explicit OpenScene(std::uint64_t seed) : random_(seed), scene_(random_.driven_scene()) {
    for (const auto& part : scene_.parts) {
      all_.push_back(engine::make_subsystem(engine::read_diagram(part.name, part.text), {.step = part.step}));
      bench_.add(part.name, *all_.back());
    }
    for (const Connection& c : scene_.connections) bench_.topology.connect(c);
    for (const auto& part : scene_.parts)
      for (const char* port : {".u", ".y"}) bench_.topology.set_start(part.name + port, 0.0);
    for (const auto& [port, series] : scene_.data) open(port);
    bench_.coordination = scene_.coordination;
    bench_.coordination.pauses = true;
    bench_.coordination.diverged_beyond = std::numeric_limits<double>::infinity();  // some do
    bench_.make(scene_.t_stop, scene_.t_start).observe(&bench_.recording);
    run().initialize();
  }

  /// Made up to pause number k.
  void go_to(int k) {
    const double from = time(k - 1);
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const Segment piece{from, from, {std::sin(static_cast<double>(k * 7) + static_cast<double>(i))}};
      run().open_input(open_[i].first, open_[i].second).go_on(from, Signal(&piece, 1, 0));
    }
    run().tell_jumps();
    run().run_to(time(k));
  }
  std::vector<std::byte> state() {
    ByteWriter to;
    run().save(to);
    return {to.bytes().begin(), to.bytes().end()};
  }
  void restore(std::span<const std::byte> bytes) {
    ByteReader from(bytes, "scene", "state of");
    run().restore(from);
    from.end();
  }
  /// The newest row of each.
  std::vector<double> newest() const {
    std::vector<double> all;
    for (int i = 0; i < bench_.topology.size(); ++i) {
      const History& history = bench_.coordinator->exchange().history(i);
      const double* row = history.row(history.newest());
      all.insert(all.end(), row, row + Samples::header + history.outputs());
    }
    return all;
  }
  static constexpr int pauses = 24;

 private:
  Coordinator& run() { return *bench_.coordinator; }
  double time(int k) const {
    return k == pauses
               ? scene_.t_stop
               : scene_.t_start + (scene_.t_stop - scene_.t_start) * (k + 0.3 * std::sin(3.0 * k)) / pauses;
  }
  void open(const std::string& port) {
    for (int i = 0; i < bench_.topology.size(); ++i)
      for (int k = 0; k < bench_.topology.info(i).input_size(); ++k)
        if (bench_.topology.input_name(i, k) == port) {
          bench_.topology.leave_open(i, k, 0.1);
          open_.emplace_back(i, k);
        }
  }

  RandomScenes random_;
  RandomScene scene_;
  std::vector<std::unique_ptr<Subsystem>> all_;
  std::vector<std::pair<int, int>> open_;
  RunBench bench_;
};

TEST(Pauses, WhatIsSavedThereGoesOnWithTheSameBitsHereAndElsewhere) {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE(seed);
    OpenScene whole(seed), other(seed);
    const int cut = 1 + static_cast<int>(seed * 11 % (OpenScene::pauses - 1));
    for (int k = 1; k <= cut; ++k) whole.go_to(k);
    const auto saved = whole.state();
    std::map<int, std::vector<double>> expected;
    for (int k = cut + 1; k <= OpenScene::pauses; ++k) whole.go_to(k), expected[k] = whole.newest();
    const auto expect_same = [&](OpenScene& again) {
      again.restore(saved);
      for (int k = cut + 1; k <= OpenScene::pauses; ++k) {
        again.go_to(k);
        ASSERT_EQ(again.newest(), expected[k]) << "pause " << k << ", saved at " << cut;
      }
    };
    expect_same(other);
    expect_same(whole);
  }
}

/// The last number of a state.
TEST(Pauses, AStateThatPausesOutsideOfItsRunIsRefused) {
  OpenScene scene(1);
  scene.go_to(1);
  const auto state = scene.state();
  for (const double stop : {std::nan(""), -1e9, 1e9, std::numeric_limits<double>::infinity()}) {
    auto other = state;
    const auto bytes = to_wire(stop);
    std::copy(bytes.begin(), bytes.end(), other.end() - sizeof stop);
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"pauses at t = ", "allowed is a time within the run"},
                        [&] { scene.restore(other); }));
  }
}

}  // namespace
}  // namespace tandem::test
