// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/classical_steps.hpp"
#include "tandem/engine/integrators/integrator.hpp"

namespace tandem::engine {

/// ClassicalSteps, as long as the caller asks for. If events are not to be located, a change of sign is seen
/// at the end of the step.
class RungeKutta4 final : public Integrator {
 public:
  explicit RungeKutta4(bool locate_events = true) : locate_events_(locate_events) {}
  void restart(System& system, double t, Restart why) override;
  double advance(System& system, double t, double t_end) override;
  bool goes_by_image() const override { return true; }
  bool takes_reaction() const override { return true; }
  Statistics statistics() const override;

 private:
  bool locate_events_;
  long restarts_ = 0;
  ClassicalSteps<System> steps_;
};

}  // namespace tandem::engine
