// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass/experiment.hpp"

#include <chrono>
#include <limits>
#include <memory>

#include "tandem/error.hpp"
#include "two_mass/masses.hpp"

namespace tandem::two_mass {
namespace {

Model model_of(const Case& c) {
  Settings settings;
  settings.frequency_ratio = c.frequency_ratio;
  settings.steps_per_cycle = c.steps_per_cycle;
  return Model(settings);
}

/// The subsystems of a case, how they are connected, and their coordinator.
class Run {
 public:
  Run(const Case& c, const Model& model, bool profile = false) {
    if (c.scheme.monolithic()) {
      subsystems_.push_back(std::make_unique<FixedStep<BothMasses>>(BothMasses(model)));
      topology_.add("both", subsystems_[0]->info());
    } else {
      couple(c, model);
    }
    topology_.check();
    Coordination coordination;
    coordination.profile = profile;
    coordination.diverged_beyond = std::numeric_limits<double>::infinity();  // Measures ends it
    if (!c.scheme.monolithic()) coordination.schedule = Schedule::parse(c.scheme.schedule);
    std::vector<Subsystem*> members;
    for (const auto& s : subsystems_) members.push_back(s.get());
    coordinator_.emplace(topology_, members, coordination, TimeSpan{0.0, c.cycles});
  }
  Coordinator& coordinator() { return *coordinator_; }

  void count(Outcome& outcome) const {
    const bool monolithic = subsystems_.size() == 1;
    outcome.exchanges = coordinator_->effort(0).exchanges;
    outcome.evaluations = (monolithic ? 8 : 4) * all_steps(0);
    if (monolithic) return;
    outcome.exchanges += coordinator_->effort(1).exchanges;
    outcome.evaluations += 2 * all_steps(1);
  }

 private:
  std::int64_t all_steps(int side) const {
    return coordinator_->effort(side).steps + coordinator_->effort(side).start_steps;
  }
  void couple(const Case& c, const Model& model) {
    subsystems_.push_back(std::make_unique<FixedStep<FastMass>>(FastMass(model, {})));
    subsystems_.push_back(
        std::make_unique<FixedStep<SlowMass>>(SlowMass(model, {.reuse_acceleration = c.reuse_acceleration})));
    topology_.add("fast", subsystems_[0]->info());
    topology_.add("slow", subsystems_[1]->info());
    topology_.connect({"slow.x2", "fast.x2", Reconstruction::parse(c.scheme.to_fast)});
    topology_.connect({"fast.x1", "slow.x1", Reconstruction::parse(c.scheme.to_slow)});
  }

  std::vector<std::unique_ptr<Subsystem>> subsystems_;
  Topology topology_;
  std::optional<Coordinator> coordinator_;
};

/// Of all rounds, without the start.
double seconds_of(Coordinator& coordinator) {
  coordinator.initialize();
  const auto started = std::chrono::steady_clock::now();
  while (coordinator.round()) {
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
}

}  // namespace

Outcome run_case(const Case& c, const std::function<void(const Model&, const Measures&)>& look) {
  const Model model = model_of(c);
  Measures measures(model, c.frequency_ratio, c.cycles);
  Run run(c, model);
  run.coordinator().observe(&measures);
  Outcome outcome;
  try {
    run.coordinator().run();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::numerical) throw;
    measures.fail(error.what());
  }
  run.count(outcome);
  outcome.figures = measures.figures();
  look(model, measures);
  return outcome;
}

Outcome run_case(const Case& c) {
  return run_case(c, [](const Model&, const Measures&) {});
}

double time_case(const Case& c) {
  const Model model = model_of(c);
  Run run(c, model);
  return seconds_of(run.coordinator());
}

Profile profile_case(const Case& c) {
  const Model model = model_of(c);
  Run run(c, model, true);
  const double total = seconds_of(run.coordinator());
  const double slow = c.scheme.monolithic() ? 0.0 : run.coordinator().effort(1).seconds;
  return {total, run.coordinator().effort(0).seconds, slow};
}

}  // namespace tandem::two_mass
