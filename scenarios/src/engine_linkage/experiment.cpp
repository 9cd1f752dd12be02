// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "engine_linkage/experiment.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine_linkage/linkage.hpp"
#include "output/on_grid.hpp"
#include "tandem/engine/subsystem.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/subsystem.hpp"

namespace tandem::engine_linkage {
namespace {

constexpr double lost = 10.0;  // [rad/s]

Coupled coupled(const Case& c, const engine::Description& engine, double stop, bool profile) {
  mbs::StepperSettings stepper;
  stepper.index3.penalty = 1e10;
  return {
      mbs::make_subsystem(mbs::read_mechanism("linkage", linkage_text(c.loops)), {c.linkage_step(), stepper}),
      engine::make_subsystem(engine, {c.engine_step}), c.scheme, stop, profile};
}

/// Gathers the differences of the linkage's first output.
class Difference final : public Observer {
 public:
  explicit Difference(const Truth& truth) : truth_(truth) {}
  bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) override {
    for (std::int64_t k = first; k <= last && subsystem == 0 && largest_ <= lost; ++k) {
      if (!on_grid(history, k, Truth::grid)) continue;
      const double d = std::abs(history.values(k)[0] - truth_.speed(history.time(k)));
      largest_ = d <= largest_ ? largest_ : d;
      sum_ += d * d;
      ++count_;
      time_ = history.time(k);
    }
    return largest_ <= lost;
  }
  void tell(Outcome& outcome) const {
    outcome.largest = largest_;
    outcome.rms = std::sqrt(sum_ / static_cast<double>(count_));
    if (!(largest_ <= lost)) outcome.note = "lost at " + std::to_string(time_) + " s";
  }

 private:
  const Truth& truth_;
  double largest_ = 0.0, sum_ = 0.0, time_ = 0.0;
  std::int64_t count_ = 0;
};

}  // namespace

Outcome run_case(const Case& c, const engine::Description& engine, const Truth& truth) {
  Coupled run = coupled(c, engine, t_stop, false);
  Difference difference(truth);
  run.coordinator().observe(&difference);
  Outcome outcome;
  try {
    run.coordinator().run();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::numerical) throw;
    outcome.note = error.what();
  }
  difference.tell(outcome);
  outcome.stable = outcome.note.empty();
  outcome.exchanges = run.exchanges();
  return outcome;
}

Elapsed time_case(const Case& c, const engine::Description& engine, double duration) {
  Coupled run = coupled(c, engine, duration, true);
  Coordinator& coordinator = run.coordinator();
  coordinator.initialize();
  const double engine_start = coordinator.effort(1).seconds, linkage_start = coordinator.effort(0).seconds;
  const auto began = std::chrono::steady_clock::now();
  while (coordinator.round()) {
  }
  const double total = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return {total, coordinator.effort(1).seconds - engine_start, coordinator.effort(0).seconds - linkage_start,
          run.exchanges()};
}

}  // namespace tandem::engine_linkage
