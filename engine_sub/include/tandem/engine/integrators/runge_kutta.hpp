// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/engine/integrators/integrator.hpp"

namespace tandem::engine {

/// The classical method of order 4 (W. Kutta, Z. Math. Phys. 46 (1901) 435), as long a step as it is asked
/// for. A change of sign is located by steps of other lengths from the same beginning, to 1e-12 of the step
/// or the rounding of time, so the order is kept across events; if events are not to be located, it is seen
/// at the end of the step.
class RungeKutta4 final : public Integrator {
 public:
  explicit RungeKutta4(bool locate_events = true) : locate_events_(locate_events) {}
  void restart(System& system, double t, Restart why) override;
  double advance(System& system, double t, double t_end) override;
  bool goes_by_image() const override { return true; }
  Statistics statistics() const override { return statistics_; }

 private:
  void step(System& system, double t, double h);
  double locate(System& system, double t, double t_end);
  void try_step(System& system, double t, double h);

  bool locate_events_;
  Statistics statistics_;
  std::vector<double> start_, rate_, sum_, first_;
};

}  // namespace tandem::engine
