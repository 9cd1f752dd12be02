// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tandem/study/coded_metric.hpp"
#include "tandem/study/ranks.hpp"
#include "tandem/study/study.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::study {

/// What the caller says of a sweep beside its study.
struct SweepSettings {
  std::filesystem::path folder;             ///< Of its tables; it is made if it is not there.
  std::vector<std::string> overrides = {};  ///< "KEY=VALUE" of the study's scenario.
  CodedMetrics metrics = {};                ///< That the study may name.
  unsigned threads = 1;                     ///< Rows that are run at the same time, unless they are timed.
  bool resume = false;     ///< Keep the rows that are there, if nothing that made them has changed.
  Ranks* ranks = nullptr;  ///< Processes that share it, of which this is one; threads has no meaning then.
};

/// Who listens to a sweep: called by the thread that sweeps, now and then.
struct SweepListener {
  std::function<bool()> going = {};  ///< false: the sweep ends there, interrupted
  /// what: "references", "rows" or "timed rows".
  std::function<void(const char* what, std::size_t done, std::size_t all)> come = {};
};

/// How a sweep ended.
struct SweepEnd {
  std::size_t rows = 0, done = 0, kept = 0;     ///< of all tables; kept: from an earlier sweep
  std::map<std::string, std::size_t> statuses;  ///< of the rows: ok, lost, unstable, failed, refused
  std::vector<std::filesystem::path> files;     ///< that were written
  std::vector<std::string> notes;  ///< sentences: references that failed, an earlier sweep of another study
  bool interrupted = false, reference_failed = false;
};

/// Throws Error with the place in the study for one of "KEY=VALUE", of its scenario, that the study sets again.
void refuse_without_effect(const std::vector<std::string>& overrides, const Study& study);

/// A study with what runs it: its rows and the references that they need. Writes TABLE.csv for each of its
/// tables, with TABLE.json (units, what made it, the references), and TABLE.series.csv for runs that it
/// keeps. A row that is finished goes to TABLE.part at once, which TABLE.csv takes the place of. The bits of
/// both files depend on neither threads nor resuming. Order of calls: plan or run.
class Sweep {
 public:
  /// Reads the scenario with the values of each row. `study` and `builtins` must outlive it. Throws Error for
  /// what is wrong with them.
  Sweep(const Study& study, const Builtins& builtins, SweepSettings settings);
  ~Sweep();
  Sweep(const Sweep&) = delete;
  Sweep& operator=(const Sweep&) = delete;

  /// What it would do, in lines: tables, references, the rows that would be refused, and about how long it would
  /// take, by the beginnings of some runs. Nothing is written.
  std::vector<std::string> plan();

  /// Throws Error(input_output) for a file that can't be written, with the rows kept that are finished. It
  /// throws any other Error for what is wrong with the study: an output that is not there, a reference that
  /// can't be read, all rows refused. With ranks each of them calls it; ranks above 0 return when rank 0 has
  /// ended, with nothing.
  SweepEnd run(const SweepListener& listener = {});

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace tandem::study
