// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/stability/fast_period.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "tandem/error.hpp"
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
  const auto [rates, parts] = participation(whole);
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

/// The slow side's output that one of a surrogate stands for; else the same.
std::string without_surrogate(const scenario::Scenario& scenario, const std::string& output) {
  for (const auto& entry : scenario.subsystems) {
    if (!entry.impulse) continue;
    const auto& links = entry.impulse->links;
    for (std::size_t k = 0; k < links.size(); ++k) {
      const std::string number = links.size() > 1 ? fmt::format("_{}", k + 1) : "";
      if (output == entry.name + ".displacement" + number) return links[k].displacement;
      const auto& velocity = links[k].effective.velocity;
      if (velocity && output == entry.name + ".velocity" + number) return *velocity;
    }
  }
  return output;
}

/// As an array of TOML.
std::string order_of_sides(const scenario::Scenario& scenario, std::vector<std::string> order) {
  for (const auto& entry : scenario.subsystems)
    if (entry.impulse) std::erase(order, entry.name);
  return fmt::format("[\"{}\"]", fmt::join(order, "\", \""));
}

}  // namespace

scenario::Scenario by_signals(const scenario::Scenario& scenario) {
  std::vector<std::string> other = {"coordination.coupling=signals"};
  if (const auto& order = scenario.coordination.order; !order.empty())
    other.push_back("coordination.order=" + order_of_sides(scenario, order));
  auto apart = scenario::with_usual(scenario::with_taken(scenario, std::move(other)));
  for (auto& entry : apart.connections)
    entry.connection.from = without_surrogate(scenario, entry.connection.from);
  if (apart.judge) apart.judge->quantity = without_surrogate(scenario, apart.judge->quantity);
  apart.plots.clear(), apart.recording.ports.clear();
  return apart;
}

scenario::Scenario with_fast_period(scenario::Scenario scenario, const Builtins& builtins) {
  if (!scenario::lacks_fast_period(scenario)) return scenario;
  try {
    const scenario::Scenario apart = by_signals(scenario);
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
