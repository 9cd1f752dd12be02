// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <unordered_set>
#include <vector>

#include "tandem/sources/view_table.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::view {

/// A mechanism of a run, read from the file that its results name.
struct RunMechanism {
  std::string instance;
  std::filesystem::path file;
  mbs::Description description;
  ViewTable view;
};

/// Results as they are read back.
struct Run {
  std::filesystem::path place;
  nlohmann::json about;  ///< results.json; an empty object for a CSV file alone
  std::vector<text::TimeTable> tables;
  std::unordered_set<std::string> columns;  ///< names of all tables
  std::vector<RunMechanism> mechanisms;
  std::vector<std::string> indicators = {};  ///< columns of indicators.csv that are shown at first

  std::string unit(const std::string& column) const;  ///< empty if it is not known
  bool held(const std::string& column) const;         ///< constant from row to row
  bool has(const std::string& column) const { return columns.contains(column); }
};

/// place: the folder of a run, or a CSV file alone. Throws Error with what is missing.
Run read_run(const std::filesystem::path& place);

/// Adds the mechanisms of the scenario that results.json names, from their files as they are now. Throws
/// Error that names a file which is not there, or what is wrong in it.
void read_mechanisms(Run& run);

/// Throws Error that says how to record it if the position of a point or vector that moves is missing.
void check_positions(const Run& run);

}  // namespace tandem::view
