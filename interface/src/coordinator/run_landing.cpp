// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Who ends own steps at the instants of sampled subsystems, and what a user should know of it.
#include <algorithm>
#include <limits>

#include "../number_text.hpp"
#include "run_start.hpp"
#include "tandem/error.hpp"

namespace tandem {

Landing landing(std::string_view text) {
  if (text == "automatic") return Landing::automatic;
  if (text == "always") return Landing::always;
  if (text == "never") return Landing::never;
  throw Error(ErrorCode::invalid_argument,
              "land '" + std::string(text) + "' is not one of automatic, always, never");
}

Landing RunStart::landing_of(int who) const {
  const auto asked = run_.coordination_.landing.find(topology_.name(who));
  return asked == run_.coordination_.landing.end() ? Landing::automatic : asked->second;
}

/// The shortest period at whose samples it ends a step.
double RunStart::shortest_period(int who) const {
  const Landing landing = landing_of(who);
  if (landing == Landing::never || !topology_.info(who).abilities.lands)
    return std::numeric_limits<double>::infinity();
  return landing == Landing::always ? 0.0 : run_.own_step(who) - rounding();
}

/// Of the ends of a line one integrates itself, the other is sampled and feeds it, or is in a loop with it.
bool RunStart::meets_samples(const Line& line) const {
  const auto loop = [&](int who) { return times_.loop[static_cast<std::size_t>(who)]; };
  return sampled(line.reader) != sampled(line.source) &&
         (sampled(line.source) || loop(line.source) == loop(line.reader));
}

/// Whether the one that integrates itself ends a step at each instant of the other, or so much before that as
/// the line lags: where that is more than the period, too late is it known when.
bool RunStart::lands(const Line& line) const {
  if (sampled(line.reader) && lag_of(line) > topology_.info(line.reader).sampling.period + rounding())
    return false;
  const int who = sampled(line.reader) ? line.source : line.reader,
            other = sampled(line.reader) ? line.reader : line.source;
  return meets_samples(line) &&
         topology_.info(other).sampling.period >= times_.shortest_period[static_cast<std::size_t>(who)];
}

/// By subsystem that integrates itself: the sampled ones at whose instants it ends a step, or, where it reads
/// them, itself or by others, does not.
void RunStart::note_landing() const {
  if (!run_.has_samples_) return;
  std::vector<std::vector<int>> met(clocks_.size()), missed(clocks_.size());
  const auto add = [&](bool ends, int who, int other) {
    add_once((ends ? met : missed)[static_cast<std::size_t>(who)], other);
  };
  for (const Line& line : topology_.lines()) {
    if (!meets_samples(line)) continue;
    const bool reads = sampled(line.source), ends = lands(line);
    const int who = reads ? line.reader : line.source, other = reads ? line.source : line.reader;
    if (ends || reads) add(ends, who, other);
  }
  for (const Watch& watch : times_.watches) add(lands(watch), watch.reader, watch.source);
  for (std::size_t i = 0; i < met.size(); ++i) {
    note_missed(static_cast<int>(i), missed[i]);
    note_multiplied(static_cast<int>(i), met[i]);
  }
}

void RunStart::note_missed(int who, const std::vector<int>& others) const {
  if (others.empty()) return;
  std::string names = "'" + topology_.name(others[0]) + "'";
  if (others.size() > 1) names += " and " + std::to_string(others.size() - 1) + " more";
  note_missed(who, "samples of " + names);
}

void RunStart::note_missed(int who, const std::string& what) const {
  const std::string why = !topology_.info(who).abilities.lands ? "it can't shorten a step"
                          : landing_of(who) == Landing::never  ? "land = \"never\" says so"
                                                               : "they come more often than its own steps";
  run_.notes_.push_back("subsystem '" + topology_.name(who) + "' does not end own steps at the " + what +
                        ", as " + why +
                        "; where it does not split them there itself, it errs to first order");
}

void RunStart::note_multiplied(int who, const std::vector<int>& others) const {
  double share = 0.0;  // of samples to own steps
  for (const int other : others) share += run_.own_step(who) / topology_.info(other).sampling.period;
  if (share <= 1.0 + rounding() / run_.own_step(who) || topology_.info(who).abilities.chooses_step) return;
  run_.notes_.push_back("subsystem '" + topology_.name(who) + "' takes up to " + number_text(1.0 + share, 2) +
                        " times its own steps, as it ends one at each sample of those that it is linked to; "
                        "land = \"never\" prevents it");
}

}  // namespace tandem
