// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/engine/system.hpp"

namespace tandem::engine {

/// Moves the states of a system.
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Before the first step, and after states, held values or the inputs' course have changed at once.
  virtual void restart(System& system, double t) = 0;

  /// From t to t_end, or to the first change of a watched sign on the way, just past it; adaptive integrators
  /// may stop earlier, at the end of one of their steps. Every signal of the system is as at t, but for what
  /// follows from inputs that have jumped since, and is left as at the time that it returns. Throws
  /// Error(numerical) if it can't.
  virtual double advance(System& system, double t, double t_end) = 0;
};

}  // namespace tandem::engine
