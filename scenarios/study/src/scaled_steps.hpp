// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "tandem/scenario/scenario.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::study {

/// Scenarios with scaled steps. Which parameters make them is tried once for all that differ in their schedule and their
/// reconstructions alone: trying opens the subsystems, and starts their programs.
class ScaledSteps {
 public:
  explicit ScaledSteps(const Builtins& builtins) : builtins_(builtins) {}

  /// As scenario::scale_steps. From any thread.
  void scale(scenario::Scenario& scenario, double factor);

 private:
  using ParametersOfEach = std::vector<std::vector<scenario::Parameter>>;

  const Builtins& builtins_;
  std::mutex mutex_;
  std::map<std::string, ParametersOfEach> known_;
};

}  // namespace tandem::study
