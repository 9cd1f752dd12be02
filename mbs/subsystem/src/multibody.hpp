// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "signal_inputs.hpp"
#include "tandem/fixed_step.hpp"
#include "tandem/mbs/mechanism/outputs.hpp"
#include "tandem/mbs/subsystem.hpp"

namespace tandem::mbs {

/// The model of a FixedStep. A copy is a state that is kept: it shares the machinery and remembers what the
/// stepper goes by besides the state.
class Multibody {
 public:
  Multibody(Description description, const SubsystemSettings& settings);
  Multibody(const Multibody& other);
  Multibody& operator=(const Multibody& other);

  SubsystemInfo info() const;
  double own_step() const { return step_; }
  void start(double t, std::span<const double> u0);
  void step(const OwnStep& s, std::span<const Signal> u);
  void outputs(double* y) const;

 private:
  struct Machine {
    Machine(Description description, const SubsystemSettings& settings);
    Mechanism mechanism;
    std::unique_ptr<Stepper> stepper;
    Outputs outputs;
    int derivatives = 0;  ///< of the output that has most
    SignalInputs inputs;
    MatrixDump dump;
    std::size_t dumped = 0;  ///< of its times
  };
  std::vector<double> memory() const { return kept_ ? memory_ : machine_->stepper->memory(); }
  void hide_unknown(double* y) const;
  void dump_matrices() const;

  std::shared_ptr<Machine> machine_;
  double step_ = 0.0;
  State state_;
  std::vector<InputValue> inputs_;  ///< by port, at the end of the last step
  std::vector<int> unknown_;        ///< inputs that are not known yet
  std::vector<double> memory_;      ///< Stepper::memory(), of a state that is kept
  bool kept_ = false;
};

}  // namespace tandem::mbs
