// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace tandem::test {

/// What the independent program tests/oracle/two_mass_oracle prints of a run.
struct OracleRow {
  double position_error, energy_error, exchange_energy_error, amplitude_error, phase_error;
  double x1, v1, x2, v2;  ///< at the end
  long fast_steps, slow_steps, calls;
};

/// Runs it with these arguments, as on a command line. Throws std::runtime_error if it can't be run or fails.
OracleRow ask_oracle(const std::string& arguments);

}  // namespace tandem::test
