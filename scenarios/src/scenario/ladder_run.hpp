// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>

#include "scenario/ladder.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::scenario {

/// The rungs of a scene's ladder, each a scenario that is ready to run.
class Ladder {
 public:
  /// Reads them; `overrides` are put in last, into each. Throws Error if the scene has no ladder, a rung is
  /// no scenario or records at own steps. `scene` and `builtins` must outlive it.
  Ladder(const Scenario& scene, const std::vector<std::string>& overrides, const Builtins& builtins);

  std::size_t size() const { return rungs_.size(); }
  /// Runs a rung, which leaves results.csv in folder/NAME; one that fails numerically is told in the result.
  /// going is asked between rounds: false ends it with Error(numerical). Throws Error if a rung gives none of
  /// the quantities.
  RungRun run(std::size_t rung, const std::filesystem::path& folder, const std::function<bool()>& going);
  /// Processor time of a run without its start and recording, of all threads of this process [s].
  double seconds(std::size_t rung, const std::function<bool()>& going) const;
  /// After all have run. Throws Error for a unit into which the output's does not convert.
  std::vector<LadderColumn> columns(const std::vector<RungRun>& runs) const;

 private:
  std::vector<std::string> take_quantities(Scenario& rung, const LadderRung& entry) const;
  std::string unit_in_richest(const LadderQuantity& judged) const;
  const LadderEntry& entry_;
  const Builtins& builtins_;
  std::vector<Scenario> rungs_;
};

}  // namespace tandem::scenario
