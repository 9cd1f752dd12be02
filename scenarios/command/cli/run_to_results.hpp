// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/run_matrices.hpp"

namespace tandem::cli {

/// What `tandem run` is asked for.
struct RunOptions {
  std::filesystem::path file, output, resume;
  std::optional<double> checkpoint_every;  ///< [s], simulated
  std::vector<std::string> overrides;
  int threads = 1;
  Matrices matrices;
  bool estimate = false;
  bool dry = false, run_programs = false, profile = false, no_reference = false;
};

/// One run, from the scenario's file to its results. Throws RunFailed for one that failed or was interrupted,
/// with its results kept, and Error for what is wrong before it begins.
void run_to_results(const RunOptions& options, const Context& context);

/// Up to the first step, with nothing written; unless it was said that they may be run, without sources that
/// are code.
void run_dry(const RunOptions& options, const Context& context);

}  // namespace tandem::cli
