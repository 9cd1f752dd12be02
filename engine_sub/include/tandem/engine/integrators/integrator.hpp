// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/engine/system.hpp"

namespace tandem::engine {

/// What an integrator has done since it was made.
struct Statistics {
  long steps = 0, rate_evaluations = 0, root_evaluations = 0;
  long failed_error_tests = 0, nonlinear_iterations = 0, failed_iterations = 0, jacobians = 0, restarts = 0;
};

/// Moves the states of a system.
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Throws Error(invalid_argument) for a setting that does not fit the diagram.
  virtual void check_fit(const std::vector<std::string>& /*state_names*/) const {}

  /// Before the first step, and after states, held values or the inputs' course have changed at once.
  virtual void restart(System& system, double t, Restart why) = 0;

  /// From t to t_end, or to the first change of a watched sign on the way, just past it; adaptive integrators
  /// may stop earlier, at the end of one of their steps. Every signal of the system is as at t, but for what
  /// follows from inputs that have jumped since, and is left as at the time that it returns. Throws
  /// Error(numerical) if it can't.
  virtual double advance(System& system, double t, double t_end) = 0;

  /// Whether its steps are its own, so that it has to stop where an input jumps or bends.
  virtual bool chooses_steps() const { return false; }
  /// Whether it goes by the system's image alone, so that restart() changes nothing of what follows: it has
  /// neither a past of steps nor lengths of its own.
  virtual bool goes_by_image() const { return false; }
  /// Whether the states of a reaction can follow those of the system (System::react), and come and go.
  virtual bool takes_reaction() const { return false; }
  virtual Statistics statistics() const = 0;
};

}  // namespace tandem::engine
