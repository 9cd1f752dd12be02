// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/integrators/integrator.hpp"
#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

/// A model's equations as a second-order problem in coordinates y, which any integrator advances. Its
/// accelerations() throw Error(numerical) with the time and the names of what is singular or not finite.
class Formulation : public SecondOrder {
 public:
  /// Completes a state of which time, q and v satisfy the constraints: accelerations and multipliers.
  virtual void start(State& state) = 0;
  /// The motion of y from a complete state, before a step. True: y are other coordinates than before.
  virtual bool begin(const State& state, Motion& motion) = 0;
  /// The complete state of a motion, after a step. Precondition: the last evaluation was at that motion.
  virtual void finish(const Motion& motion, State& state) = 0;
  /// Accelerations and multipliers anew, of a state that is complete but for a change of inputs.
  virtual void refresh(State& state) = 0;
  /// alpha in the matrix M + alpha Phi_q^T Phi_q that it factorizes; 0 if there is none.
  virtual double penalty() const { return 0.0; }
  /// See Stepper::remember().
  virtual void remember(std::vector<double>& to) const = 0;
  virtual void recall(std::span<const double> memory) = 0;
};

}  // namespace tandem::mbs
