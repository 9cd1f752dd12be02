// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::cli {

struct Drawing {
  std::vector<charts::Picture> pictures;
  std::string table;  ///< printed beside them; may be empty
};

/// What `tandem chart NAME` draws.
struct ChartScene {
  const char *name, *folder;                              ///< folder: where `command` writes by default
  const char* command;                                    ///< that makes the files, with {} for the folder
  std::vector<const char*> files;                         ///< that have to be in the folder
  Drawing (*draw)(const std::filesystem::path& results);  ///< throws Error for a file that is no such table
};

std::span<const ChartScene> chart_scenes();

}  // namespace tandem::cli
