// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a turn costs among many subsystems.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "bench/bench.hpp"
#include "tandem/coordinator/coordinator.hpp"
#include "tandem/sampled.hpp"

namespace tandem::bench {
namespace {

constexpr int signals = 2;  // from a source to each of its readers

/// Evaluates its inputs at the end of each own step and gives the mean of each signal's, damped by more than
/// a polynomial of degree 3 amplifies.
class Partner final : public Subsystem {
 public:
  Partner(int sources, double own_step) : own_step_(own_step) {
    info_ = {"null", {{"u", "1", signals * sources}}, {{"y", "1", signals}}, {}, {}};
  }
  const SubsystemInfo& info() const override { return info_; }
  tandem::Clock initialize(double t_start, double, std::span<const double>, Samples& y) override {
    grid_ = TimeGrid(t_start, own_step_);
    double* row = y.append(t_start);
    for (int k = 0; k < signals; ++k) row[k] = 1.0 + 0.1 * k;
    return {grid_.time(), grid_.next(), Stop::limit};
  }
  tandem::Clock advance(double t_limit, bool, std::span<const Signal> u, Samples& y) override {
    const double share = 0.01 * signals / static_cast<double>(u.size());
    do {
      grid_.step();
      double* row = y.append(grid_.time());
      for (int k = 0; k < signals; ++k) row[k] = 1.0;
      for (std::size_t i = 0; i < u.size(); ++i) row[i % signals] += share * u[i].value(grid_.time());
    } while (!y.full() && grid_.fits(t_limit));
    return {grid_.time(), grid_.next(), Stop::limit};
  }

 private:
  SubsystemInfo info_;
  double own_step_;
  TimeGrid grid_;
};

constexpr double fast_step = 2e-5;  // s

/// Samples its inputs at each step of a fast partner.
class Controller {
 public:
  SubsystemInfo info() const { return {"null", {{"u", "1", signals}}, {{"y", "1", signals}}, {}, {}}; }
  double own_step() const { return fast_step; }
  void start(double, std::span<const double>) { y_.fill(1.0); }
  void outputs(double* y) const { std::copy(y_.begin(), y_.end(), y); }
  void step(const OwnStep& own, std::span<const Signal> u) {
    for (std::size_t k = 0; k < y_.size(); ++k) y_[k] = 1.0 + 0.01 * u[k].value(own.begin);
  }

 private:
  std::array<double, signals> y_{};
};

/// pairs: 2k and 2k + 1 read each other; ring: each reads the one before it; hub: 0 and each other one read
/// each other; sampled: 3k, which is slow, and 3k + 1, which is fast, read each other, and so do 3k + 1 and
/// 3k + 2, a controller.
class Network {
 public:
  Network(const std::string& topology, const std::string& schedule, int count) {
    for (int i = 0; i < count; ++i)
      if (topology == "sampled" && i % 3 != 0)
        add_fast(i);
      else
        add(i, topology == "hub" && i == 0 ? count - 1 : 1);
    for (int i = 0; i < count; ++i) {
      if (topology == "ring") connect((i + count - 1) % count, i, 0);
      if (topology == "pairs") connect(i ^ 1, i, 0);
      if (topology == "hub" && i > 0) connect(0, i, 0), connect(i, 0, i - 1);
      if (topology == "sampled" && i % 3 > 0) connect(i - 1, i, 0), connect(i, i - 1, i % 3 - 1);
    }
    topology_.check();
    std::vector<Subsystem*> pointers;
    for (const auto& partner : partners_) pointers.push_back(partner.get());
    Coordination coordination;
    coordination.schedule = Schedule::parse(schedule);
    coordination.start = StartKind::cold;
    run_.emplace(topology_, pointers, coordination, TimeSpan{0.0, 1e9});
    run_->initialize();
  }
  void round() { run_->round(); }
  double turns() const {
    double sum = 0.0;
    for (int i = 0; i < topology_.size(); ++i) sum += static_cast<double>(run_->effort(i).exchanges);
    return sum;
  }

 private:
  /// Steps between 1 and 2 ms that have nothing in common, so that turns do not come in lockstep.
  void add(int i, int sources) {
    const double part = std::fmod(0.6180339887 * i, 1.0);
    partners_.push_back(std::make_unique<Partner>(sources, 1e-3 * (1.0 + part)));
    topology_.add("s" + std::to_string(i), partners_.back()->info());
  }
  void add_fast(int i) {
    if (i % 3 == 1)
      partners_.push_back(std::make_unique<Partner>(2, fast_step));
    else
      partners_.push_back(std::make_unique<Sampled<Controller>>(Controller()));
    topology_.add("s" + std::to_string(i), partners_.back()->info());
  }
  void connect(int source, int reader, int place) {
    const bool held = topology_.info(source).abilities.sampled;
    for (int k = 0; k < signals; ++k)
      topology_.connect({fmt::format("s{}.y[{}]", source, k),
                         fmt::format("s{}.u[{}]", reader, signals * place + k),
                         held ? Reconstruction{} : Reconstruction::parse("lagrange3")});
  }

  std::vector<std::unique_ptr<Subsystem>> partners_;
  Topology topology_;
  std::optional<Coordinator> run_;
};

struct NetworkSetting {
  std::string topology, schedule;
  int count;
  std::string name() const { return fmt::format("{} {} {}", topology, schedule, count); }
};

std::vector<NetworkSetting> network_settings() {
  std::vector<NetworkSetting> all;
  for (const char* schedule : {"slowest-first", "parallel"})
    for (const char* topology : {"pairs", "ring", "hub"})
      for (const int count : {2, 20, 200, 2000, 20000}) all.push_back({topology, schedule, count});
  for (const char* schedule : {"slowest-first", "parallel"})
    for (const int count : {3, 30, 300, 3000}) all.push_back({"sampled", schedule, count});
  return all;
}

}  // namespace

Table topologies() {
  std::map<std::string, double> turns_per_round;
  std::vector<Timing> timings;
  for (const NetworkSetting& s : network_settings())
    timings.push_back({s.name(), [s, &turns_per_round](benchmark::State& state) {
                         Network network(s.topology, s.schedule, s.count);
                         const double before = network.turns();
                         for (auto _ : state) network.round();
                         turns_per_round[s.name()] =
                             (network.turns() - before) / static_cast<double>(state.iterations());
                       }});
  const auto seconds = measure(timings, 11, 0.05);
  Table table({"topology", "schedule", "subsystems", "ns_per_turn", "turns_per_round"}, "topologies");
  for (const NetworkSetting& s : network_settings()) {
    const double turns = turns_per_round.at(s.name());
    table.add({s.topology, s.schedule, std::to_string(s.count),
               fmt::format("{:.1f}", 1e9 * seconds.at(s.name()) / turns), fmt::format("{:.1f}", turns)});
  }
  return table;
}

}  // namespace tandem::bench
