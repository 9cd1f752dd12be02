// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/coordinator/coordination.hpp"

namespace tandem::study {

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
  void between_rounds() override {
    for (Observer* one : all_) one->between_rounds();
  }

 private:
  std::vector<Observer*> all_;
};

}  // namespace tandem::study
