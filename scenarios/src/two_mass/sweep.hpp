// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "two_mass/experiment.hpp"

namespace tandem::two_mass {

/// Rows of sweep.csv by their first four cells. A row is a line of text without its end.
class SweepTable {
 public:
  static std::string header();
  /// The first four cells of a case's row.
  static std::string key(const Case& c);
  static std::string row(const Case& c, const Outcome& outcome);

  /// Reads a table written before. Throws Error naming file and line if it is not one.
  static SweepTable read(const std::filesystem::path& file);
  /// Writes the rows there are, in the order of `cases`, to a file beside it and renames that: never half a
  /// table.
  void write(const std::filesystem::path& file, const std::vector<Case>& cases) const;

  bool has(const Case& c) const { return rows_.count(key(c)) != 0; }
  void set(const Case& c, const Outcome& outcome) { rows_[key(c)] = row(c, outcome); }
  std::size_t size() const { return rows_.size(); }

 private:
  std::map<std::string, std::string> rows_;
};

/// Runs the cases that `table` has not, on `threads` threads; each case is deterministic, so the table does
/// not depend on their order. `tick(done)` is called from the calling thread now and then; if it returns
/// false the sweep ends with what is done. Returns the seconds that each case took, by key.
std::map<std::string, double> run_sweep(const std::vector<Case>& cases, unsigned threads, SweepTable& table,
                                        const std::function<bool(std::size_t)>& tick);

/// traces.csv: x1 and the energy error over time for the runs that the charts show.
void write_traces(const std::filesystem::path& file);

/// A row of work.csv: a case, its errors, and the least time of `repetitions` runs.
/// All cases of the speed-against-accuracy chart.
std::vector<Case> work_cases();
std::string work_header();
std::string work_row(const Case& c, int repetitions);

}  // namespace tandem::two_mass
