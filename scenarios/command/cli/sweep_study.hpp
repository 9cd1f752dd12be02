// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "cli/commands.hpp"

namespace tandem::cli {

struct StudySweep {
  std::filesystem::path file;
  std::filesystem::path output;  ///< empty: results/FOLDER, the folder that the study lies in
  std::vector<std::string> overrides;
  std::vector<std::string> tables;  ///< those that are made; empty: all
  std::string where;                ///< an expression of columns: the rows that are run; empty: all
  unsigned threads;
  bool resume, dry;
  std::string study = {};  ///< in place of the file's, which is a scenario's
  std::uint64_t seed = 0;  ///< of values that are drawn
};

/// Sweeps a study, and tells how its rows ended.
void sweep_study(const StudySweep& settings, const Context& context);

}  // namespace tandem::cli
