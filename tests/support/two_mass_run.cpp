// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass_run.hpp"

#include <cmath>
#include <utility>

#include "two_mass/masses.hpp"

namespace tandem::test {
namespace {

using two_mass::FastMass;
using two_mass::Model;
using two_mass::Motion;
using two_mass::SlowMass;

/// Passes everything on, except that it declares no landing and refuses it.
class WithoutLanding final : public Subsystem {
 public:
  explicit WithoutLanding(std::unique_ptr<Subsystem> inner)
      : inner_(std::move(inner)), info_(inner_->info()) {
    info_.abilities.lands = false;
  }
  const SubsystemInfo& info() const override { return info_; }
  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override {
    return inner_->initialize(t_start, t_stop, u0, y);
  }
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    if (land) throw std::logic_error("asked to land, which it can't");
    return inner_->advance(t_limit, false, u, y);
  }

 private:
  std::unique_ptr<Subsystem> inner_;
  SubsystemInfo info_;
};

/// Keeps every node of both sides (fast: subsystem 0), and the states after each turn.
class Keeper final : public Observer {
 public:
  explicit Keeper(TwoMassResult& result) : result_(result) {}
  bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) override {
    auto& nodes = subsystem == 0 ? result_.fast : result_.slow;
    for (std::int64_t row = first; row <= last; ++row)
      nodes.push_back({history.time(row), history.values(row)[0], history.values(row)[1]});
    if (result_.fast.empty() || result_.slow.empty()) return true;
    const Node &f = result_.fast.back(), &s = result_.slow.back();
    result_.turns.push_back({f.x, f.v, s.x, s.v});
    return true;
  }

 private:
  TwoMassResult& result_;
};

void join(Topology& topology, const TwoMassRun& what) {
  const bool fast_gives = what.crossing == Crossing::force_from_fast,
             slow_gives = what.crossing == Crossing::force_from_slow;
  Connection to_slow{fast_gives ? "fast.F" : "fast.x1", fast_gives ? "slow.F" : "slow.x1",
                     Reconstruction::parse(what.to_slow)};
  to_slow.lag = what.lag;
  topology.connect({slow_gives ? "slow.F" : "slow.x2", slow_gives ? "fast.F" : "fast.x2",
                    Reconstruction::parse(what.to_fast)});
  topology.connect(to_slow);
  topology.check();
}

double mean_square(const Model& model, const std::vector<Node>& nodes, bool fast, double from) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const Node& n : nodes) {
    if (n.t < from) continue;
    const Motion m = model.exact(n.t);
    const double dx = n.x - (fast ? m.x1 : m.x2),
                 dv = (n.v - (fast ? m.v1 : m.v2)) / (fast ? model.omega1 : model.omega2);
    sum += dx * dx + dv * dv;
    ++count;
  }
  return sum / static_cast<double>(count);
}

}  // namespace

MakeSide exact(const ExactMass::Options& options) {
  return [options](const Model& model) {
    return std::make_unique<FixedStep<ExactMass>>(ExactMass(model, options));
  };
}
MakeSide exact_fast() { return exact({.fast = true}); }
MakeSide exact_slow() { return exact({.fast = false}); }
MakeSide real_fast(bool gives_force) {
  return [=](const Model& m) {
    return std::make_unique<FixedStep<FastMass>>(FastMass(m, {.force = gives_force}));
  };
}
MakeSide real_slow(bool reads_force) {
  return [=](const Model& m) {
    return std::make_unique<FixedStep<SlowMass>>(SlowMass(m, {.force = reads_force}));
  };
}
MakeSide reusing_slow() {
  return [](const Model& m) {
    return std::make_unique<FixedStep<SlowMass>>(SlowMass(m, {.reuse_acceleration = true}));
  };
}
MakeSide without_landing(MakeSide side) {
  return [side = std::move(side)](const Model& m) { return std::make_unique<WithoutLanding>(side(m)); };
}

void TwoMassRun::set_exact_sides(Crossing how, double exact_until) {
  using enum ExactMass::Coupling;
  crossing = how;
  ExactMass::Options f{.fast = true, .exact_until = exact_until},
      s{.fast = false, .exact_until = exact_until};
  if (how == Crossing::force_from_fast) f.coupling = gives_force, s.coupling = reads_force;
  if (how == Crossing::force_from_slow) f.coupling = reads_force, s.coupling = gives_force;
  fast = exact(f);
  slow = exact(s);
}

TwoMassRun run_at(double frequency_ratio, Schedule::Kind schedule) {
  TwoMassRun what;
  what.settings.frequency_ratio = frequency_ratio;
  what.settings.phase1 = what.settings.phase2 = 0.8;
  what.schedule = schedule;
  what.t_stop = 2.0 * frequency_ratio;  // two cycles of the slow mode
  return what;
}

TwoMassResult run(const TwoMassRun& what) {
  TwoMassResult result{Model(what.settings), {}, {}, {}, {}, 0};
  const auto fast = what.fast(result.model), slow = what.slow(result.model);
  Topology topology;
  topology.add("fast", fast->info());
  topology.add("slow", slow->info());
  join(topology, what);
  Coordination coordination;
  coordination.schedule = what.schedule;
  coordination.start = what.start;
  Coordinator coordinator(topology, {fast.get(), slow.get()}, coordination, {what.t_start, what.t_stop});
  Keeper keeper(result);
  coordinator.observe(&keeper);
  coordinator.run();
  result.notes = coordinator.notes();
  result.start = coordinator.start();
  result.start_passes = coordinator.start_passes();
  result.exchanges = coordinator.effort(0).exchanges + coordinator.effort(1).exchanges;
  return result;
}

GlobalError error_of(const TwoMassResult& r, double from) {
  return {std::sqrt(mean_square(r.model, r.fast, true, from)),
          std::sqrt(mean_square(r.model, r.slow, false, from))};
}

double position_error(const TwoMassResult& r) {
  double errors = 0.0, squares = 0.0;
  for (const Node& n : r.fast) {
    const double dx = n.x - r.model.exact(n.t).x1;
    errors += dx * dx;
    squares += n.x * n.x;
  }
  const double cycles = r.fast.back().t - r.fast.front().t;  // the fast mode's period is 1 s
  return r.model.omega1 / r.model.omega2 / cycles * std::sqrt(errors / squares);
}

double order(double coarse, double fine) { return std::log2(coarse / fine); }

}  // namespace tandem::test
