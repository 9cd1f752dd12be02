// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "running.hpp"
#include "tandem/signal.hpp"

namespace tandem::fmi {

/// An FMU of Model Exchange as x' = f(t, x) with event indicators, for ClassicalSteps; and its events. An
/// indicator's sign is that it is above 0. All calls of the library stand in Instance::within(). A copy is a
/// state that is kept (Running).
class Equations {
 public:
  explicit Equations(const std::shared_ptr<Instance>& instance);

  const Running& running() const { return running_; }
  Instance& instance() const { return running_.instance(); }

  void start(double t, std::span<const double> u0);
  /// Its states, where no event indicator and no discrete variable belongs to what it remembers.
  std::optional<std::vector<StateName>> names() const;
  void get(std::span<double> x) const { std::copy(x_.begin(), x_.end(), x.begin()); }
  void put(std::span<const double> x);
  /// Goes on with the state that is kept, and on these inputs, which outlive the call.
  void resume(std::span<const Signal> u);
  /// Whether inputs that may change at events alone have other values now.
  bool discrete_inputs_changed(double t);
  /// What happens at t, where it stands.
  void happen(double t);
  /// A step has come to its end. Whether the FMU asks for an event there.
  bool end_step();
  double next_event() const { return next_event_; }
  bool finished() const { return finished_; }

  int size() const { return static_cast<int>(x_.size()); }
  double* states() { return x_.data(); }
  void rates(double t, double* dx) {
    go_to(t);
    read_rates(dx);
  }
  void read_rates(double* dx);
  void evaluate(double t);
  void evaluate_again(double t);
  int changed() const;
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
  std::span<const Signal> u_;
  std::vector<double> x_, indicators_, inputs_;
  std::vector<double> above_;  ///< by indicator, 1 or 0: as it was last seen
  double next_event_ = 0.0;
  bool finished_ = false;
};

}  // namespace tandem::fmi
