// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <memory>
#include <optional>

#include "tandem/coordinator/coordinator.hpp"
#include "tandem/fixed_step.hpp"
#include "tandem/scenario/parts.hpp"

namespace tandem::scenario {

/// The run of a scenario that is one subsystem.
class NestedRun {
 public:
  /// step [s]; 0: that of its slowest.
  NestedRun(Scenario scenario, const Builtins& members, double step);

  const SubsystemInfo& info() const { return info_; }
  double own_step() const { return step_; }
  /// Where the next run ends [s]; infinite if that is not known.
  void end_at(double t_stop) { stop_ = t_stop; }
  void start(double t, std::span<const double> u0);
  /// On these inputs from t [s] on, where it stands.
  void read(double t, std::span<const Signal> u);
  void go_to(double t);
  void outputs(double* y) const;
  std::vector<std::string> notes() const;
  void write(ByteWriter& to) const { run_->save(to); }
  void read(ByteReader& from) { run_->restore(from); }

 private:
  struct OpenInput {
    int who, input;
    double start;
  };
  struct Told {
    int who, output, derivatives;
  };
  void note_inputs(int who);
  void note_outputs();
  void note_output(const std::string& name);
  [[noreturn]] void refuse_output(const std::string& name) const;
  void note_feedthrough(int number);
  void note_abilities();
  double slowest_step() const;
  double own_step_of(int who) const;
  double horizon(double t) const;
  const double* row(int who) const;

  Scenario scenario_;
  Parts parts_;
  SubsystemInfo info_;
  std::vector<OpenInput> inputs_;
  std::vector<Told> told_;
  Topology topology_;  ///< of the present run
  std::optional<Coordinator> run_;
  std::vector<Driven*> open_;
  double step_, stop_ = std::numeric_limits<double>::infinity(), horizon_ = 0.0;  ///< [s]
};

/// A scenario as a model with a fixed own step. A copy is what the run goes by as it was copied.
class NestedModel {
 public:
  explicit NestedModel(std::shared_ptr<NestedRun> run) : run_(std::move(run)), is_run_(true) {}
  NestedModel(NestedModel&&) = default;
  NestedModel& operator=(NestedModel&&) = default;
  NestedModel(const NestedModel& other) : run_(other.run_), bytes_(other.bytes()) {}
  NestedModel& operator=(const NestedModel& other);

  SubsystemInfo info() const { return run_->info(); }
  bool keeps_state() const { return info().abilities.serializes_state; }
  double own_step() const { return run_->own_step(); }
  void end_at(double t_stop) { run_->end_at(t_stop); }
  void start(double t, std::span<const double> u0) { run_->start(t, u0); }
  void step(const OwnStep& s, std::span<const Signal> u) { run_->read(s.begin, u), run_->go_to(s.end); }
  bool jump(double t, std::span<const Signal> u) {
    return run_->read(t, u), !run_->info().feedthrough.empty();
  }
  void outputs(double* y) const { run_->outputs(y); }
  std::vector<std::string> remarks(double) const { return run_->notes(); }
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  std::vector<std::byte> bytes() const;
  void restore(std::span<const std::byte> bytes) const;

  std::shared_ptr<NestedRun> run_;  ///< of all copies
  std::vector<std::byte> bytes_;    ///< of a copy
  bool is_run_ = false;             ///< it is none
};

}  // namespace tandem::scenario
