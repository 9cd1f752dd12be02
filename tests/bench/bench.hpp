// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <benchmark/benchmark.h>

#include <filesystem>
#include <functional>
#include <map>
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

struct Benchmark;

/// A table for the screen and for BENCHMARK.csv, or with a name of its own BENCHMARK_NAME.csv.
class Table {
 public:
  explicit Table(std::vector<std::string> columns, std::string name = "")
      : columns_(std::move(columns)), name_(std::move(name)) {}
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  const std::string& name() const { return name_; }
  const std::vector<std::vector<std::string>>& rows() const { return rows_; }
  void print() const;
  /// stem.csv, and stem.json with what charts say of it. Throws Error if a file can't be written.
  void write(const std::filesystem::path& stem, const Benchmark& benchmark) const;

 private:
  std::vector<std::string> columns_;
  std::string name_;
  std::vector<std::vector<std::string>> rows_;
};

/// Is told now and then which share of a benchmark's work is done, 0 to 1.
using Tick = std::function<void(double share)>;

/// Benchmarks by name, with a sentence about each.
struct Benchmark {
  std::string name, about;
  std::function<std::vector<Table>(const Tick&)> run;
  std::map<std::string, std::string> norms = {};  ///< what a column's numbers are, for charts
};
const std::vector<Benchmark>& all();

Table exchange();
Table topologies();
Table round_threads();
Table indicators(const Tick& tick);
Table impulse(const Tick& tick);
Table two_mass();
std::vector<Table> four_bar_linkage(const Tick& tick);
std::vector<Table> linkage_errors(const Tick& tick);
Table formulations(const Tick& tick);
Table mechanisms(const Tick& tick);
Table hand_written_linkage();
Table sparse_algebra();
std::vector<Table> linear_solvers();
Table dense_algebra();
Table threads();
Table profile();
Table integrators();
Table function_evaluation();
Table engine_models();
std::vector<Table> transports(const Tick& tick);
Table fmu();
Table engine_linkage_elsewhere(const Tick& tick);
std::vector<Table> against_simbody(const Tick& tick);  ///< only with Simbody

}  // namespace tandem::bench
