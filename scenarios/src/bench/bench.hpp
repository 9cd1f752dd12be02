// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <benchmark/benchmark.h>

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tandem::bench {

/// One thing to time: `run` does it once per iteration of the state.
struct Timing {
  std::string name;
  std::function<void(benchmark::State&)> run;
};

/// Times all of them in one process, interleaved at random, `repetitions` times each; the least seconds per
/// iteration by name (Google Benchmark's real time): what other work on the machine adds is never less than
/// nothing.
std::map<std::string, double> measure(const std::vector<Timing>& timings, int repetitions,
                                      double seconds_each);

/// A table for the screen and for results/bench/NAME.csv.
class Table {
 public:
  explicit Table(std::vector<std::string> columns) : columns_(std::move(columns)) {}
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  void print() const;
  /// Throws Error if the file can't be written.
  void write(const std::filesystem::path& file) const;

 private:
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// What a chart tells beside its figures.
struct Notes {
  std::string reference, error_norm, repetitions;
};

/// Benchmarks by name: each prints its table with a sentence about it, and returns the table for the CSV.
struct Benchmark {
  std::string name, about;
  std::function<Table()> run;
  std::optional<Notes> notes = {};  ///< for NAME_conditions.json; none: no chart
};
const std::vector<Benchmark>& all();

Table exchange();
Table two_mass();
Table four_bar_linkage();
Table sparse_algebra();
Table linear_solvers();
Table dense_algebra();
Table against_simbody();  ///< only with Simbody

}  // namespace tandem::bench
