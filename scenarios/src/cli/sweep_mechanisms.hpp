// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

#include "cli/commands.hpp"

namespace tandem::cli {

struct MechanismSweep {
  std::filesystem::path mechanisms, output;
  unsigned threads;
  bool only_table;  ///< without work.csv
};

/// Every formulation and integrator on every example mechanism: formulations.csv, errors.csv and, for the
/// chart, work.csv with work_conditions.json in the folder `output`. Throws Error if the examples' files are
/// not there, RunFailed if it is interrupted.
void sweep_mechanisms(const MechanismSweep& sweep, const Context& context);

}  // namespace tandem::cli
