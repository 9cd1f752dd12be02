// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <vector>

#include "tandem/mbs/model.hpp"
#include "tandem/mbs/sparse/tangent.hpp"

namespace tandem::mbs {

/// Moves the state of a model step by step: a formulation of its equations and an integrator of them. It may
/// keep what belongs to the last step (a factorized matrix), so it serves one run at a time; a state that was
/// kept is put back with what was remembered with it. Each function throws Error(numerical) with the time and
/// the names of what is singular, not finite or does not converge; the state is then of no use. While a
/// function runs, numbers below 2.2e-308 count as zero where the processor can (they would slow it by far).
class Stepper {
 public:
  virtual ~Stepper() = default;

  /// Completes a state of which time, q and v satisfy the constraints: accelerations and multipliers. It
  /// comes before the first step.
  virtual void start(State& state) = 0;
  /// One step of length h > 0 [s], which ends at t_end [s]; given, so that times are not accumulated. Returns
  /// the number of iterations (1 for an explicit method). It either takes this step or throws: never a
  /// smaller one.
  virtual int step(State& state, double h, double t_end) = 0;
  /// Accelerations and multipliers anew where the state stands, after an input of the model has changed.
  virtual void refresh(State& state) = 0;

  /// M + damping C + stiffness K + penalty Phi_q^T Phi_q is the matrix that steps of h [s] factorize
  /// (null_space: none, so the factors are 0).
  virtual TangentFactors tangent_factors([[maybe_unused]] double h) const { return {0.0, 0.0, 0.0}; }

  /// Appends what it goes by besides the state, after a step or start(). With the state of that moment and
  /// its memory put back, steps are the same to the last bit. That holds also for another stepper of the same
  /// kind that has started. recall() throws Error(invalid_argument) for the memory of another kind.
  virtual void remember(std::vector<double>& /*to*/) const {}
  virtual void recall(std::span<const double> /*memory*/) {}
};

}  // namespace tandem::mbs
