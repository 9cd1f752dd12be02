// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/stability/fast_period.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "tandem/error.hpp"
#include "tandem/scenario/by_signals.hpp"
#include "tandem/scenario/taken.hpp"
#include "trial.hpp"
#include "undivided.hpp"

namespace tandem::stability {
namespace {

/// Instances on the fast end of a link.
std::set<std::string> fast_sides(const scenario::Scenario& scenario) {
  std::set<std::string> all;
  for (const auto& entry : scenario.subsystems)
    if (entry.impulse)
      for (const auto& link : entry.impulse->links) all.insert(link.fast);
  return all;
}

/// Of modes in which fast sides take part [s].
double shortest_period(const std::set<std::string>& instances, const Trial& trial) {
  constexpr double least = 0.01;  // beside the state that takes part most
  const Undivided whole = undivided(trial, false, Sampled::left_out);
  const auto [rates, vectors, parts] = participation(whole);
  double fastest = 0.0;
  for (Eigen::Index mode = 0; mode < parts.cols(); ++mode)
    for (Eigen::Index k = 0; k < parts.rows(); ++k) {
      const std::string& state = whole.names[static_cast<std::size_t>(k)];
      if (instances.contains(state.substr(0, state.find('.'))) &&
          parts(k, mode) >= least * parts.col(mode).maxCoeff())
        fastest = std::max(fastest, rates[mode].imag());
    }
  if (!(fastest > 0.0)) throw Error(ErrorCode::not_supported, "the fast sides do not swing");
  return 2.0 * std::numbers::pi / fastest;
}

/// What models of sides differ by, wherever these live, is below the last digit.
double four_digits(double period) { return std::stod(fmt::format("{:.3e}", period)); }

}  // namespace

scenario::Scenario with_fast_period(scenario::Scenario scenario, const Builtins& builtins) {
  if (!scenario::lacks_fast_period(scenario)) return scenario;
  try {
    const scenario::Scenario apart = scenario::by_signals(scenario);
    const double period = shortest_period(fast_sides(scenario), Trial(apart, builtins));
    scenario::take_fast_period(scenario, four_digits(period));
  } catch (const Error& error) {
    if (error.code() != ErrorCode::not_supported) throw;
    scenario::refuse(
        scenario.place("coordination.coupling"),
        fmt::format("coordination.fast_period is not stated, and can't be found: {}; allowed is a "
                    "number above 0 [s]",
                    error.what()),
        error.code());
  }
  return scenario;
}

}  // namespace tandem::stability
