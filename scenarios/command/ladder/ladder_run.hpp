// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>

#include "ladder/ladder.hpp"
#include "tandem/coordinator/units.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::scenario {

/// Of those of a command those that are of its rungs: what is not ladder.KEY.
std::vector<std::string> overrides_of_rungs(std::vector<std::string> all);

/// Whether a source of a rung's scenario is code. Throws Error as a Ladder of these does.
bool names_code_in_rungs(const Scenario& scene, const std::vector<std::string>& overrides,
                         const Builtins& builtins);

/// The rungs of a scene's ladder, each a scenario that is ready to run, or results.
class Ladder {
 public:
  /// Reads them, and opens each once; `overrides` are put in last, into each. Throws Error if the scene has
  /// no ladder, a rung is no scenario, records at own steps or gives none of the quantities, the richest
  /// lacks one, or the unit of one does not convert into the judge's. `scene` and `builtins` must outlive it.
  Ladder(const Scenario& scene, const std::vector<std::string>& overrides, const Builtins& builtins);

  std::size_t size() const { return rungs_.size(); }
  /// Throws Error if a rung's results lie where runs of the ladder in this folder write.
  void check_folder(const std::filesystem::path& folder) const;
  /// Runs a rung, which leaves results.csv in folder/NAME; one that fails numerically is told in the result.
  /// going is asked between rounds: false ends it with Error(numerical).
  RungRun run(std::size_t rung, const std::filesystem::path& folder, const std::function<bool()>& going);
  /// Processor time of a run without its start and recording, with that of the processes that it started [s];
  /// 0 of results.
  double seconds(std::size_t rung, const std::function<bool()>& going) const;
  /// After all have run.
  std::vector<LadderColumn> columns(const std::vector<RungRun>& runs) const;

 private:
  struct Rung {
    const LadderRung& entry;
    std::optional<Scenario> scenario;
    std::optional<text::TimeTable> results;    ///< where it is no scenario
    std::vector<std::string> quantities;       ///< that it gives over time
    std::map<std::string, std::string> units;  ///< of these; empty where a file has none
  };
  void take_quantities(Rung& rung);
  void check_richest() const;
  double factor(const LadderQuantity& judged) const;
  UnitConversion conversion_of(const Rung& rung, const std::string& quantity) const;
  text::TimeTable judged_of(const Rung& rung, const text::TimeTable& all) const;

  const LadderEntry& entry_;
  const Builtins& builtins_;
  std::vector<Rung> rungs_;
  std::map<std::string, std::string> units_;  ///< by quantity, in which it is compared
};

}  // namespace tandem::scenario
