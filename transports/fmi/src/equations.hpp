// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "linearized.hpp"
#include "running.hpp"
#include "tandem/differential_system.hpp"
#include "tandem/signal.hpp"

namespace tandem::fmi {

/// An FMU of Model Exchange as x' = f(t, x) with event indicators, for ClassicalSteps; and its events. An
/// indicator's sign is that it is above 0. All calls of the library stand in Instance::within(). A copy is a
/// state that is kept (Running).
class Equations final : public DifferentialSystem {
 public:
  explicit Equations(const std::shared_ptr<Instance>& instance);

  const Running& running() const { return running_; }
  Instance& instance() const { return running_.instance(); }

  void start(double t, std::span<const double> u0);
  /// Its states, where no event indicator and no discrete variable belongs to what it remembers.
  std::optional<std::vector<StateName>> names() const;
  void get(std::span<double> x) const { std::copy(x_.begin(), x_.end(), x.begin()); }
  void put(std::span<const double> x);
  std::optional<Linearized> linearized() const { return fmi::linearized(instance()); }
  std::vector<std::string> state_names() const override;
  std::vector<double> nominals() const override;
  /// Goes on with the state that is kept, and on these inputs, which outlive the call.
  void resume(std::span<const Signal> u);
  /// From t on each input is one polynomial, up to course_end(). Whether one jumps with that.
  bool begin_course(double t);
  double course_end() const { return course_end_; }
  /// Whether inputs that may change at events alone have other values now.
  bool discrete_inputs_changed(double t);
  /// What happens at t, where it stands.
  void happen(double t);
  /// A step has come to its end. Whether the FMU asks for an event there.
  bool end_step();
  double next_event() const { return next_event_; }
  bool finished() const { return finished_; }

  int size() const override { return static_cast<int>(x_.size()); }
  double* states() override { return x_.data(); }
  void rates(double t, double* dx) override {
    go_to(t);
    read_rates(dx);
  }
  void read_rates(double* dx);
  void evaluate(double t) override;
  void evaluate_again(double t) override;
  int changed() const override;
  int watched_signals() const override { return static_cast<int>(indicators_.size()); }
  void watched_signs(double* signs) const override;
  double watched(int indicator) const { return indicators_[static_cast<std::size_t>(indicator)]; }

  /// Of a state that is kept.
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  void go_to(double t);
  void settle(double t);
  void read_states();
  void read_indicators();

  Running running_;
  std::span<const Signal> u_, given_;  ///< what is read, and all of the call
  std::vector<Signal> course_;         ///< of u_
  double course_end_ = 0.0;            ///< [s]
  std::vector<double> x_, indicators_, inputs_, inputs_before_;
  std::vector<double> above_;  ///< by indicator, 1 or 0: as it was last seen
  double next_event_ = 0.0;
  bool finished_ = false;
};

}  // namespace tandem::fmi
