// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <map>
#include <string>

#include "tandem/scenario/scenario.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::study {

/// What the rounds of a run take, from the end of its start to its last.
struct Timing {
  double seconds;    ///< wall time [s]
  double processor;  ///< of all processors, with the processes that were started and run [s]
};

class Stopwatch {
 public:
  Stopwatch();
  Timing read() const;

 private:
  std::chrono::steady_clock::time_point began_;
  double processor_;
};

/// The run with the least wall time of `repetitions`, of which `first` is one. Nothing else should run
/// meanwhile.
Timing least_time(const scenario::Scenario& scenario, const Builtins& builtins, int repetitions,
                  Timing first);

/// By subsystem: the part of the rounds' wall time that is spent inside it, of one run that reads the clock
/// at each call.
std::map<std::string, double> shares(const scenario::Scenario& scenario, const Builtins& builtins);

}  // namespace tandem::study
