// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tandem/scenario/assembly.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::scenario {

/// What the judged output is expected to be, for record.indicators = "estimate".
struct Expectation {
  std::optional<text::TimeTable> table = {};  ///< its column, and der(NAME) where it is known
  std::string why_not = {};                   ///< there is none
  double seconds = 0.0;                       ///< that it took
};

/// What the caller says of a run beside its scenario.
struct RunSettings {
  std::filesystem::path folder;                 ///< Of its results; it is made if it is not there.
  std::filesystem::path resume = {};            ///< A checkpoint that the run goes on from; empty: none.
  std::optional<double> checkpoint_every = {};  ///< FOLDER/checkpoint is written so often [s], simulated.
  int threads = 1;                              ///< Coordination::threads.
  bool profile = false;                         ///< Coordination::profile.
  bool compares = true;                         ///< With the reference that the scenario names.
  std::optional<Expectation> expectation = {};  ///< Needed by record.indicators = "estimate".
};

/// Who listens to a run: called between its rounds by the thread that runs.
struct RunListener {
  std::function<bool()> going = {};       ///< after each round; false: the run ends there, interrupted
  std::function<void(double)> come = {};  ///< about a hundred times a second: how far it has come [s]
};

/// How a run ended.
struct RunEnd {
  std::string status = "ok";              ///< "running", "ok", "failed", "diverged" or "interrupted".
  std::string message = {};               ///< Of a run that is not at its end, why.
  double seconds = 0.0;                   ///< Of the stepping loop, with the recording.
  std::string report = {};                ///< Of the comparison with the reference; empty: there was none.
  std::string indicators = {};            ///< What they say, in a line; empty: there are none.
  std::string estimate = {};              ///< Likewise, or why there is none; empty: none was wanted.
  std::vector<std::string> outside = {};  ///< What is not within the reference's tolerances, in sentences.
};

/// One run, from a scenario that was read to its results: results.csv (or results.INSTANCE.csv with
/// record.clock = "own"), indicators.csv, results.json and machine.json. The file results.json says "running" before any row
/// is written, and how it ended at last: nobody finds the status of an earlier run beside the rows of this
/// one.
///
/// Order of calls:
/// 1. start
/// 2. finish
class Run {
 public:
  /// Opens the subsystems and keeps the folder for this run alone. `scenario` and `builtins` must outlive it.
  /// Throws Error for what is wrong before the run begins.
  Run(const Scenario& scenario, const Builtins& builtins, RunSettings settings);
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Up to the first step, or to where the checkpoint stands. Throws Error; if files were begun they are
  /// kept, and their status is "failed".
  void start();
  /// Steps to the end, compares and writes. A run that fails is told in what it returns, with its rows kept.
  RunEnd finish(const RunListener& listener = {});

  /// All that comes before the first step, with nothing written. Throws what start() throws. The notes.
  static std::vector<std::string> check(const Scenario& scenario, const Builtins& builtins,
                                        RunSettings settings);

  const Assembly& assembly() const;
  /// How far it has come [s].
  double time() const;
  /// Of results, with results.json and machine.json.
  std::vector<std::filesystem::path> files() const;
  /// Sentences on what a user should know: of coordinator, subsystems, recording and checkpoints.
  std::vector<std::string> notes() const;

 private:
  class Stages;
  std::unique_ptr<Stages> stages_;
};

/// The results that a run is compared with; the scenario names some. Throws Error with the place for what is no
/// table, and for results of a run that did not come to its end.
text::TimeTable reference_of(const Scenario& scenario);

/// Start and finish in one call.
RunEnd run(const Scenario& scenario, const Builtins& builtins, RunSettings settings,
           const RunListener& listener = {});

}  // namespace tandem::scenario
