// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/linkage_run.hpp"

namespace tandem::bench {

/// What is found of a case.
struct LinkageOutcome {
  double seconds = 0.0, iterations = 0.0;  ///< of a step
  double mechanism_bytes = 0.0, stepper_bytes = 0.0;
  bool timed = false, at_end = false;
  double x_error = 0.0, drift = 0.0;  ///< at the end
  std::string failure;                ///< its sentence
};
using LinkageOutcomes = std::map<LinkageCase, LinkageOutcome>;

/// What each case is timed for, roughly [s].
inline constexpr double timing_patience = 0.15;

/// Times of a step of cases with the same linkage: the first steps of the motion, of small linkages over the
/// first passage of the flat position. Solvers take turns; of each twentieth of the steps the least time
/// counts. Bytes are what the heap holds more with the linkage and with the stepper after a step.
void time_cases(const std::vector<LinkageCase>& cases, LinkageOutcomes& outcomes);

}  // namespace tandem::bench
