// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tandem/scenario/scenario.hpp"
#include "tandem/study/standing.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::advice {

/// A scheme of the standing study (study/standing.hpp), with what is predicted of it.
struct Choice {
  std::string schedule, reconstruction;  ///< "impulse", "impulse_taylor": coupled so
  double steps;                          ///< times all own steps and the communication step
  double error;                          ///< as a part of the tolerance
  double exchanges;                      ///< calls of subsystems
  double own_steps;                      ///< of all subsystems together
  std::vector<std::string> order = {};   ///< coordination.order; empty: as the scenario has it

  bool is_impulse() const { return reconstruction.starts_with("impulse"); }
};

struct Ranking {
  std::vector<Choice> choices;  ///< the smallest error first; of those within 1 % the fewest exchanges first
  std::size_t others = 0;       ///< that failed, were lost or refused

  /// Of those within the tolerance the one with the fewest exchanges, then the fewest own steps.
  std::optional<Choice> cheapest() const;
};

/// Of a ranking of short runs those that are worth a whole one, the cheapest first. Each is better than all that are
/// cheaper. But for the best they are at most ten times the tolerance off. Precondition: it is not empty.
std::vector<Choice> finalists(const Ranking& ranking);

/// coordination.order, as "KEY=VALUE".
std::string override_of(const std::vector<std::string>& order);

/// From the table `schemes` of the standing study.
Ranking ranking(const std::filesystem::path& table);

/// What a choice puts into a scenario, as overrides: schedule, reconstructions, and where they are scaled the
/// communication step and the parameters of own steps. varied: as of the study that it is of.
std::vector<std::string> taken(const Choice& choice, const scenario::Scenario& scenario,
                               const Builtins& builtins, study::Varied varied);
/// The same as lines of TOML.
std::string lines(const Choice& choice, const scenario::Scenario& scenario, const Builtins& builtins,
                  study::Varied varied);
/// Why, in words: how often the fastest mode is sampled a cycle, and what the scheme makes of its amplitude over the run.
/// Nothing where the map of a super-step does not tell (stability/super_step.hpp).
std::string reason(const scenario::Scenario& chosen, const Builtins& builtins);

}  // namespace tandem::advice
