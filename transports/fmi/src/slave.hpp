// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "running.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem::fmi {

/// An FMU of Co-Simulation that takes steps, for SavedModels. All calls but those of start() stand in
/// Instance::within().
class Slave {
 public:
  explicit Slave(const std::shared_ptr<Instance>& instance);

  SubsystemInfo info() const { return running_.info(); }
  double own_step() const { return running_.own_step(); }
  bool keeps_state() const { return running_.keeps_state(); }
  bool finished() const { return finished_; }
  Instance& instance() const { return running_.instance(); }

  void start(const TimeSpan& span, std::span<const double> u0);
  /// Takes a step as far as the FMU goes. Returns the time that it has come to.
  double step(const OwnStep& s, std::span<const Signal> u);
  void outputs(double* y) const { running_.read_row(y); }
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  void set_inputs(const OwnStep& s, std::span<const Signal> u);
  double over(const OwnStep& s, const Signal& u) const;
  void set_derivatives(double t, std::span<const Signal> u);
  double discarded(const OwnStep& s);
  void check_own_time(const OwnStep& s);

  Running running_;
  std::vector<double> values_;
  std::vector<fmi2ValueReference> references_;  ///< of continuous inputs, once for each order
  std::vector<fmi2Integer> orders_;
  std::vector<double> derivatives_;
  int own_time_ = -1;  ///< the variable that is the FMU's time
  bool finished_ = false;
};

}  // namespace tandem::fmi
