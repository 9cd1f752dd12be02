// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>

#include "bench/bench.hpp"
#include "tandem/coordinator/coordinator.hpp"

namespace tandem::bench {
namespace {

/// Takes one own step (all of a ring have the same, so that no call lets it take more), evaluates its inputs
/// at the end of it and returns one sample: their values, damped by more than a polynomial of degree 4
/// amplifies, so that a ring of them stays bounded.
class NullSubsystem final : public Subsystem {
 public:
  explicit NullSubsystem(int signals) {
    info_ = {"null", {}, {}, {}, {}};
    for (int i = 0; i < signals; ++i) {
      info_.inputs.push_back({"u" + std::to_string(i), "1"});
      info_.outputs.push_back({"y" + std::to_string(i), "1"});
    }
  }
  const SubsystemInfo& info() const override { return info_; }
  Clock initialize(double t_start, double, std::span<const double>, Samples& y) override {
    grid_ = TimeGrid(t_start, 0.001);
    double* row = y.append(t_start);
    for (std::size_t i = 0; i < info_.outputs.size(); ++i) row[i] = 1.0 + 0.1 * static_cast<double>(i);
    return {grid_.time(), grid_.next(), Stop::limit};
  }
  Clock advance(double, bool, std::span<const Signal> u, Samples& y) override {
    grid_.step();
    double* row = y.append(grid_.time());
    for (std::size_t i = 0; i < u.size(); ++i) row[i] = 0.01 * u[i].value(grid_.time()) + 1.0;
    return {grid_.time(), grid_.next(), Stop::limit};
  }

 private:
  SubsystemInfo info_;
  TimeGrid grid_;
};

struct Setting {
  std::string schedule, reconstruction;
  int signals = 2, subsystems = 2;
  std::string name() const {
    return fmt::format("{} {} {} signals, {} subsystems", schedule, reconstruction, signals, subsystems);
  }
};

/// Subsystems in a ring (two: each reads the other), all with the same step.
class Ring {
 public:
  explicit Ring(const Setting& s) : turns_(s.schedule == "parallel" ? 1 : s.subsystems) {
    for (int i = 0; i < s.subsystems; ++i) members_.push_back(std::make_unique<NullSubsystem>(s.signals));
    for (int i = 0; i < s.subsystems; ++i)
      topology_.add("s" + std::to_string(i), members_[static_cast<std::size_t>(i)]->info());
    for (int i = 0; i < s.subsystems; ++i)
      for (int k = 0; k < s.signals; ++k)
        topology_.connect({fmt::format("s{}.y{}", i, k), fmt::format("s{}.u{}", (i + 1) % s.subsystems, k),
                           Reconstruction::parse(s.reconstruction)});
    std::vector<Subsystem*> pointers;
    for (const auto& m : members_) pointers.push_back(m.get());
    Coordination coordination;
    coordination.schedule = Schedule::parse(s.schedule);
    coordination.start = StartKind::cold;
    coordinator_.emplace(topology_, pointers, coordination, TimeSpan{0.0, 1e9});
    coordinator_->initialize();
  }
  void round() {
    for (int i = 0; i < turns_; ++i) coordinator_->round();
  }

 private:
  int turns_;
  std::vector<std::unique_ptr<NullSubsystem>> members_;
  Topology topology_;
  std::optional<Coordinator> coordinator_;
};

/// The same round by hand, for two of the same null subsystems behind the same virtual interface: a Newton
/// polynomial of fixed degree 3 through the last four samples of a fixed number of signals, nothing checked,
/// scheduled or kept.
template <int Signals>
class HandWritten {
 public:
  HandWritten() : sides_{Side(Signals), Side(Signals)} {}
  void round() {
    step(sides_[0], sides_[1]);
    step(sides_[1], sides_[0]);
  }

 private:
  struct Side {
    explicit Side(int signals) : subsystem(std::make_unique<NullSubsystem>(signals)) {
      Samples y(row.data(), stride, 1);
      clock = subsystem->initialize(0.0, 1e9, {}, y);
      for (std::size_t i = 0; i < 4; ++i) t[i] = -0.001 * static_cast<double>(i);
      for (auto& values : y4) values.fill(1.0);
    }
    static constexpr std::int64_t stride = Samples::header + Signals;
    std::unique_ptr<Subsystem> subsystem;
    std::array<double, stride> row{};
    std::array<double, 4> t{};  // newest first
    std::array<std::array<double, 4>, Signals> y4{};
    std::array<Segment, Signals> segments{};
    Clock clock{};
  };

  static void step(Side& self, Side& other) {
    std::array<Signal, Signals> u;
    for (std::size_t k = 0; k < Signals; ++k) {
      interpolate(other.t, other.y4[k], other.segments[k]);
      u[k] = Signal(&other.segments[k], 1, 3);
    }
    Samples y(self.row.data(), Side::stride, 1);
    self.clock = self.subsystem->advance(self.clock.next_time, false, u, y);
    self.t = {self.row[0], self.t[0], self.t[1], self.t[2]};
    for (std::size_t k = 0; k < Signals; ++k) {
      auto& y4 = self.y4[k];
      y4 = {self.row[Samples::header + k], y4[0], y4[1], y4[2]};
    }
  }
  static void interpolate(const std::array<double, 4>& t, const std::array<double, 4>& y, Segment& s) {
    const double e1 = t[0] - t[1], e2 = t[0] - t[2], e3 = t[0] - t[3];
    const double a = (y[0] - y[1]) / e1, b = (y[1] - y[2]) / (t[1] - t[2]), c = (y[2] - y[3]) / (t[2] - t[3]);
    const double d = (a - b) / e2, e = (b - c) / (t[1] - t[3]), f = (d - e) / e3;
    s = {t[0], t[0], {y[0], a + e1 * (d + e2 * f), d + (e1 + e2) * f, f, 0.0, 0.0}};
  }

  std::array<Side, 2> sides_;
};

template <int Signals>
Timing by_hand() {
  return {fmt::format("hand-written, {} signals", Signals), [](benchmark::State& state) {
            HandWritten<Signals> loop;
            for (auto _ : state) loop.round();
          }};
}

std::vector<Setting> settings() {
  std::vector<Setting> list;
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const int signals : {2, 4}) list.push_back({schedule, "lagrange3", signals, 2});
  for (const char* how :
       {"lagrange0", "lagrange1", "lagrange2", "lagrange4", "least_squares2_2", "matched_hold"})
    list.push_back({"slowest-first", how, 2, 2});
  for (const int signals : {1, 8, 32}) list.push_back({"slowest-first", "lagrange3", signals, 2});
  for (const int subsystems : {3, 5, 10}) list.push_back({"slowest-first", "lagrange3", 2, subsystems});
  return list;
}

}  // namespace

Table exchange() {
  std::vector<Timing> timings = {by_hand<1>(), by_hand<2>(), by_hand<4>(), by_hand<8>(), by_hand<32>()};
  for (const Setting& s : settings())
    timings.push_back({s.name(), [s](benchmark::State& state) {
                         Ring ring(s);
                         for (auto _ : state) ring.round();
                       }});
  const auto seconds = measure(timings, 40, 0.01);
  Table table({"schedule", "reconstruction", "signals_each_way", "subsystems", "ns_per_round",
               "hand_written_ns", "ratio"});
  for (const Setting& s : settings()) {
    const double ns = 1e9 * seconds.at(s.name());
    const bool comparable = s.subsystems == 2 && s.reconstruction == "lagrange3";
    const double hand =
        comparable ? 1e9 * seconds.at(fmt::format("hand-written, {} signals", s.signals)) : 0.0;
    table.add({s.schedule, s.reconstruction, std::to_string(s.signals), std::to_string(s.subsystems),
               fmt::format("{:.1f}", ns), comparable ? fmt::format("{:.1f}", hand) : "",
               comparable ? fmt::format("{:.2f}", ns / hand) : ""});
  }
  return table;
}

}  // namespace tandem::bench
