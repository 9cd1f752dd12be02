// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/integrators/runge_kutta.hpp"

namespace tandem::engine {

void RungeKutta4::restart(System& system, double, Restart) {
  ++restarts_;
  steps_.resize(system.size());
}

double RungeKutta4::advance(System& system, double t, double t_end) {
  return steps_.advance(system, t, t_end, locate_events_);
}

Statistics RungeKutta4::statistics() const {
  Statistics all;
  all.steps = steps_.steps();
  all.rate_evaluations = 4 * steps_.steps();
  all.restarts = restarts_;
  return all;
}

}  // namespace tandem::engine
