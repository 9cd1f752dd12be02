// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tandem/engine/subsystem.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem::engine {

/// Inputs of a diagram from the signals of a call, or constants.
class SignalInputs final : public InputSource {
 public:
  /// z: the states of the reaction that some of them have, where they stand; else null.
  void set(std::span<const Signal> signals, const double* z = nullptr) {
    signals_ = signals, z_ = z, courses_.clear();
  }
  void set_constants(std::span<const double> values) {
    constants_.assign(values.begin(), values.end()), signals_ = {}, courses_.clear();
  }
  void at(double t, double* values) override;
  double begin_course(double t) override;
  bool jump_at(double t) override;

 private:
  std::span<const Signal> signals_;
  const double* z_ = nullptr;
  std::vector<Signal> courses_;  ///< the segment of each that is followed
  std::vector<double> constants_;
};

/// The model of a FixedStep. A copy is a state that is kept: it shares the machinery.
class DiagramModel {
 public:
  DiagramModel(const Description& diagram, const SubsystemSettings& settings);
  DiagramModel(const DiagramModel& other);
  DiagramModel& operator=(const DiagramModel& other);

  SubsystemInfo info() const;
  double own_step() const { return step_; }
  void start(double t, std::span<const double> u0);
  void react(const Reaction* reaction);
  std::span<const double> reaction_states() const { return machine_->simulation.reaction_states(); }
  bool step_to_event(OwnStep& s, std::span<const Signal> u);
  void outputs_before(double* y) const;
  bool jump(double t, std::span<const Signal> u);
  void outputs(double* y) const;
  std::vector<std::string> remarks(double t_stop) const;
  std::optional<std::vector<StateName>> states() const;
  void get_states(std::span<double> x) const;
  void set_states(std::span<const double> x);
  void write(ByteWriter& to) const;
  void read(ByteReader& from);
  /// Of a sampled diagram: what happens at its instant t; or what it would give, and nothing changes.
  void act(double t, std::span<const double> u);
  void look(double t, std::span<const double> u, double* y);
  double next_instant() const { return machine_->simulation.next_periodic(); }
  std::vector<Figure> figures() const;
  const Program& program() const { return machine_->program; }

 private:
  void check_step(const std::string& name) const;
  struct Machine {
    Machine(const Description& diagram, const SubsystemSettings& settings);
    Description diagram;  ///< without its blocks
    Program program;
    SignalInputs inputs;
    Simulation simulation;
    std::vector<double> before;  ///< of look()
  };

  /// What it was when it was kept, else what it is.
  const std::vector<double>& image() const { return kept_.empty() ? machine_->simulation.signals() : kept_; }
  void set_inputs(std::span<const Signal> u);
  /// Goes on with the state that is kept.
  Simulation& resume();

  std::shared_ptr<Machine> machine_;
  double step_ = 0.0;
  std::vector<bool> hidden_ = {};  ///< outputs that follow an unknown input at once
  std::vector<double> kept_;       ///< Simulation::state(), of a state that is kept
  double kept_time_ = 0.0;
};

}  // namespace tandem::engine
