// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "moving_state.hpp"
#include "signal_inputs.hpp"
#include "tandem/fixed_step.hpp"
#include "tandem/mbs/mechanism/independent.hpp"
#include "tandem/mbs/mechanism/outputs.hpp"
#include "tandem/mbs/subsystem.hpp"

namespace tandem::mbs {

/// The model of a FixedStep of a mechanism.
class Multibody {
 public:
  Multibody(Description description, const SubsystemSettings& settings);

  SubsystemInfo info() const;
  double own_step() const { return step_; }
  void start(double t, std::span<const double> u0);
  bool step_to_event(OwnStep& s, std::span<const Signal> u);
  void outputs_before(double* y) const;
  bool jump(double t, std::span<const Signal> u);
  void outputs(double* y) const;
  std::vector<std::string> remarks(double t_stop) const;
  std::shared_ptr<SlowModel> slow_model(std::span<const SlowLink> links) const;
  std::optional<std::vector<StateName>> states() const;
  void get_states(std::span<double> x) const;
  void set_states(std::span<const double> x);
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  struct Machine {
    Machine(Description description, const SubsystemSettings& settings);
    void note_jumps();
    Mechanism mechanism;
    std::shared_ptr<Stepper> stepper;
    Outputs outputs;
    int derivatives = 0;         ///< of the output that has most
    bool feeds_through = false;  ///< an input to an output
    std::vector<double> jumps;   ///< of inputs that are functions of time, ascending [s]
    bool outputs_jump = false;   ///< with them
    std::vector<double> before;  ///< a row, of before the last of them
    SignalInputs inputs;
    MatrixDump dump;
    std::size_t dumped = 0;  ///< of its times
    Limits limits;
    bool begun = false;                      ///< a step has been taken since the start
    std::optional<Independent> independent;  ///< once somebody has asked for states
  };

  const Independent& independent() const;
  bool take_inputs(double t, std::span<const Signal> u);
  bool move(OwnStep& s);
  void pass_jump(double t, const OwnStep& part);
  void hide_unknown(double* y) const;
  std::vector<std::string> redundant_equations() const;
  void dump_matrices() const;

  std::shared_ptr<Machine> machine_;
  double step_ = 0.0;
  MovingState moving_;
  std::vector<InputValue> inputs_;  ///< by port, at the end of the last step
  std::vector<int> unknown_;        ///< inputs that are not known yet
};

}  // namespace tandem::mbs
