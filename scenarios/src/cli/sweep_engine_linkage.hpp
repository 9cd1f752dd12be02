// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

#include "cli/commands.hpp"

namespace tandem::cli {

struct EngineLinkageSweep {
  std::filesystem::path scene, output;  ///< scene: the folder of engine.toml and engine_linkage.toml
  unsigned threads;
  bool only_table;  ///< without work.csv and elapsed.csv
};

/// Engine and linkage by every scheme: schemes.csv, equal_steps.csv, results.csv (the scene's own run) and,
/// for the charts, work.csv, elapsed.csv and conditions.json in the folder `output`. Throws Error if the
/// scene's files are not there, RunFailed if it is interrupted.
void sweep_engine_linkage(const EngineLinkageSweep& sweep, const Context& context);

}  // namespace tandem::cli
