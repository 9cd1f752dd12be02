// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "tandem/engine/simulation.hpp"

// What a run goes by, from outside: states that are kept and put, and those of a reaction.
namespace tandem::engine {

void Simulation::react(const tandem_reaction* reaction) {
  const int before = system_.size();
  system_.react(reaction);
  if (system_.size() != before) integrator_->restart(system_, time_, Restart::state);
}

const std::vector<double>& Simulation::keep() {
  integrator_->restart(system_, time_, Restart::state);
  return system_.image();
}

void Simulation::restore(double t, std::span<const double> state) {
  std::copy(state.begin(), state.end(), system_.image().begin());
  time_ = t;
  begun_ = t != start_;
  integrator_->restart(system_, t, Restart::state);
}

void Simulation::put_states(std::span<const double> x) {
  std::copy(x.begin(), x.end(), system_.states());
  system_.evaluate(time_);
  integrator_->restart(system_, time_, Restart::state);
}

}  // namespace tandem::engine
