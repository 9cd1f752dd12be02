// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "running.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem::fmi {

/// An FMU of Co-Simulation that takes steps, for SavedModels. All calls but those of start() stand in
/// Instance::within(). One of 3.0 that has an event mode has events: at changes of its discrete inputs, at
/// times that it tells before, and after steps of which it says so.
class Slave {
 public:
  explicit Slave(const std::shared_ptr<Instance>& instance);

  SubsystemInfo info() const { return running_.info(); }
  double own_step() const { return running_.own_step(); }
  bool keeps_state() const { return running_.keeps_state(); }
  bool finished() const { return finished_; }
  Instance& instance() const { return running_.instance(); }

  void start(const TimeSpan& span, std::span<const double> u0);
  /// Whether discrete inputs have other values at t, where it stands.
  bool inputs_changed(double t, std::span<const Signal> u) {
    return take(running_.fmu().ports.discrete, u, t, values_);
  }
  /// Whether the FMU has an event of its own there.
  bool is_due(double t) const {
    return due_ || (std::isfinite(next_event_) && !TimeTolerance(t).before(t, next_event_));
  }
  /// An event there, with all inputs as they are at t. True: outputs have jumped.
  bool happen(double t, std::span<const Signal> u);
  /// Where a step from s.begin is to end, which may end earlier than s does: at an event that is known before,
  /// also one that is later by rounding alone.
  double end_of(const OwnStep& s) const;
  /// Takes a step as far as the FMU goes. Returns the time that it has come to.
  double step(const OwnStep& s, std::span<const Signal> u);
  void outputs(double* y) const { running_.read_row(y); }
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  bool has_events() const { return running_.info().abilities.events; }
  void settle(double t);
  void set_inputs(const OwnStep& s, std::span<const Signal> u);
  double over(const OwnStep& s, const Signal& u) const;
  void set_derivatives(const OwnStep& s, std::span<const Signal> u);
  void check_progress(const OwnStep& s, const Taken& taken);

  Running running_;
  std::vector<double> values_;             ///< of inputs
  std::vector<double> before_, after_;     ///< rows around an event
  std::vector<std::uint32_t> references_;  ///< of continuous inputs, once for each order
  std::vector<int> orders_;
  std::vector<double> derivatives_;
  double next_event_, stop_;
  int standing_ = 0;  ///< steps in which the FMU did not go on
  bool due_ = false, finished_ = false;
};

}  // namespace tandem::fmi
