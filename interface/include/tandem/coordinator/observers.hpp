// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/coordinator/coordination.hpp"

namespace tandem {

/// Several observers of one run. The run goes on while all of them want it to.
class Observers final : public Observer {
 public:
  /// It must outlive the run.
  void add(Observer& one) { all_.push_back(&one); }

  bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) override {
    bool going = true;
    for (Observer* one : all_) going = one->samples(subsystem, history, first, last) && going;
    return going;
  }
  void inputs(int subsystem, TimeSpan span, std::span<const Signal> lanes) override {
    for (Observer* one : all_) one->inputs(subsystem, span, lanes);
  }
  void inputs_at(int subsystem, double t, std::span<const double> lanes) override {
    for (Observer* one : all_) one->inputs_at(subsystem, t, lanes);
  }
  void went_back(int subsystem, double t) override {
    for (Observer* one : all_) one->went_back(subsystem, t);
  }
  void between_rounds() override {
    for (Observer* one : all_) one->between_rounds();
  }

 private:
  std::vector<Observer*> all_;
};

}  // namespace tandem
