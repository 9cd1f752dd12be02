// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "tandem/advice/advice.hpp"
#include "tandem/identification/models.hpp"
#include "tandem/study/standing.hpp"

namespace tandem::cli {

/// Predicts error and cost of the schemes that a scenario may take, by its standing study with models in the places of its
/// subsystems. Of a scenario that chooses (coordination.scheme = "auto") only what it leaves out is varied.
class Adviser {
 public:
  /// folder: gets the study's table, schemes.csv.
  Adviser(const scenario::Scenario& asked, std::filesystem::path folder, unsigned threads,
          const Context& context);

  /// Finds the models. What it says of them, and of who leads, line by line.
  std::vector<std::string> look();
  /// After look(). Throws RunFailed where no scheme comes to an error. What one run of the scheme that is chosen says of
  /// the models; where they are too far off, all is predicted anew without them.
  std::vector<std::string> predict();
  /// [s] of look() and of predict().
  std::array<double, 2> seconds() const { return seconds_; }

  const advice::Ranking& ranking() const { return ranking_; }
  /// Those that ran to the end, where each scheme of the ranking did not; else that one.
  const advice::Ranking& last() const { return at_end_ ? *at_end_ : ranking_; }
  /// What these are compared with; empty: they are the ranking.
  const std::string& beside() const { return beside_; }
  /// Where the scheme that is chosen stands.
  std::filesystem::path table() const {
    return folder_ / (led_ ? "orders" : at_end_ ? "to_the_end" : "") / "schemes.csv";
  }
  /// Within the tolerance.
  std::optional<advice::Choice> cheapest() const { return last().cheapest(); }
  /// The cheapest within the tolerance of [judge]; where none is, or the scenario has no [judge], the best. It has the
  /// better of all orders that were tried with it.
  advice::Choice chosen() const { return led_ ? *led_ : chosen_of(last()); }
  std::vector<std::string> taken(const advice::Choice& choice) const;
  /// What it puts into the scenario, as TOML.
  std::string lines(const advice::Choice& choice) const;
  /// Why, in words; empty where nothing is known.
  std::string reason(const advice::Choice& choice) const;

 private:
  std::vector<std::string> of_models();
  advice::Choice chosen_of(const advice::Ranking& all) const;
  std::string of_source(const identification::Stand& one) const;
  std::string shorten();
  void rank_all();
  std::optional<std::string> check_models();
  double off_of(const advice::Choice& choice);
  std::optional<std::string> choose_order();
  void set_order(const Coordinator& run);
  void find_orders();
  advice::Ranking swept(const std::filesystem::path& folder, const std::vector<std::string>& overrides,
                        const study::Standing& standing, const std::string& where, const Context& context);
  void go_to_the_end();

  study::Varied varied_;
  Builtins builtins_;
  scenario::Scenario scenario_;  ///< as it is stated
  std::filesystem::path folder_;
  unsigned threads_;
  identification::Models models_;
  Context advised_, itself_;            ///< with models, and without
  std::vector<std::string> order_;      ///< coordination.order, where it is taken for all schemes
  std::vector<std::string> overrides_;  ///< of the runs
  std::optional<double> up_to_;         ///< where each scheme ends, if that is before the scenario does [s]
  std::map<std::string, std::vector<std::vector<std::string>>> orders_;  ///< by schedule; the usual one first
  study::Finest finest_;                                                 ///< of last()
  advice::Ranking ranking_;
  std::optional<advice::Ranking> at_end_;
  std::optional<advice::Choice> led_;  ///< the scheme that is chosen, with another order
  std::string beside_;
  std::array<double, 2> seconds_{};
};

/// "fastest-first, hermite, steps x 1".
std::string words(const advice::Choice& choice);

/// A scenario that chooses, with what it takes. folder: as above.
scenario::Scenario advised(const scenario::Scenario& asked, const std::filesystem::path& folder,
                           const Context& context);

}  // namespace tandem::cli
