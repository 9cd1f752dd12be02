// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "cli/commands.hpp"

namespace tandem::cli {

struct KartSweep {
  std::filesystem::path scene, output;  ///< scene: the folder of the kart's mechanisms
  std::vector<std::string> levels;      ///< of kart::levels; empty: all
  bool only_table;                      ///< without work.csv and traces.csv
};

/// The kart with its engine at each level: multirate.csv, schemes.csv, work.csv, traces.csv and
/// conditions.json in the folder `output`, one run at a time. Throws Error if the scene's files are not
/// there, RunFailed if it is interrupted.
void sweep_kart(const KartSweep& sweep, const Context& context);

}  // namespace tandem::cli
