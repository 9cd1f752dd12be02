// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/network.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tandem/sampled.hpp"

namespace tandem::bench {
namespace {

constexpr int signals = 2;  // from a source to each of its readers

/// Evaluates its inputs at the end of each own step and gives the mean of each signal's, damped by more than
/// a polynomial of degree 3 amplifies.
class Partner final : public Subsystem {
 public:
  Partner(int sources, double own_step, long operations = 0) : own_step_(own_step), operations_(operations) {
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
    burn();
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
  /// Each operation waits for the one before it.
  void burn() {
    double x = 1.0;
    for (long k = 0; k < operations_; ++k) benchmark::DoNotOptimize(x = 0.5 * x + 0.5);
  }

  SubsystemInfo info_;
  double own_step_;
  long operations_;
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

}  // namespace

std::string Network::Setting::name() const {
  return fmt::format("{} {} {} {} {}", topology, schedule, count, operations, threads);
}

Network::Network(const Setting& setting) : setting_(setting) {
  const auto& [topology, schedule, count, operations, threads] = setting_;
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
  coordination.threads = threads;
  run_.emplace(topology_, pointers, coordination, TimeSpan{0.0, 1e9});
  run_->initialize();
}

double Network::turns() const {
  double sum = 0.0;
  for (int i = 0; i < topology_.size(); ++i) sum += static_cast<double>(run_->effort(i).exchanges);
  return sum;
}

/// Steps between 1 and 2 ms that have nothing in common, so that turns do not come in lockstep.
void Network::add(int i, int sources) {
  const double part = std::fmod(0.6180339887 * i, 1.0);
  partners_.push_back(std::make_unique<Partner>(sources, 1e-3 * (1.0 + part), setting_.operations));
  topology_.add("s" + std::to_string(i), partners_.back()->info());
}

void Network::add_fast(int i) {
  if (i % 3 == 1)
    partners_.push_back(std::make_unique<Partner>(2, fast_step));
  else
    partners_.push_back(std::make_unique<Sampled<Controller>>(Controller()));
  topology_.add("s" + std::to_string(i), partners_.back()->info());
}

void Network::connect(int source, int reader, int place) {
  const bool held = topology_.info(source).abilities.sampled;
  for (int k = 0; k < signals; ++k)
    topology_.connect({fmt::format("s{}.y[{}]", source, k),
                       fmt::format("s{}.u[{}]", reader, signals * place + k),
                       held ? std::nullopt : std::optional(Reconstruction::parse("lagrange3"))});
}

}  // namespace tandem::bench
