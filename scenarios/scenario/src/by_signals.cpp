// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/by_signals.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "impulse.hpp"
#include "tandem/scenario/taken.hpp"

namespace tandem::scenario {
namespace {

/// The slow side's output that one of a surrogate stands for; else the same.
std::string without_surrogate(const Scenario& scenario, const std::string& output) {
  for (const SubsystemEntry& entry : scenario.subsystems) {
    if (!entry.impulse) continue;
    const auto& links = entry.impulse->links;
    for (std::size_t k = 0; k < links.size(); ++k) {
      const auto is = [&](const char* name) {
        return output == entry.name + "." + numbered(name, k, links.size());
      };
      if (is("displacement")) return links[k].displacement;
      if (const auto& velocity = links[k].effective.velocity; velocity && is("velocity")) return *velocity;
    }
  }
  return output;
}

/// As an array of TOML.
std::string order_of_sides(const Scenario& scenario) {
  std::vector<std::string> order = scenario.coordination.order;
  for (const SubsystemEntry& entry : scenario.subsystems)
    if (entry.impulse) std::erase(order, entry.name);
  return fmt::format("[\"{}\"]", fmt::join(order, "\", \""));
}

}  // namespace

Scenario by_signals(const Scenario& scenario) {
  if (!by_impulse(scenario)) return scenario;
  std::vector<std::string> other = {"coordination.coupling=signals"};
  if (!scenario.coordination.order.empty()) other.push_back("coordination.order=" + order_of_sides(scenario));
  Scenario apart = with_usual(with_taken(scenario, std::move(other)));
  for (ConnectionEntry& entry : apart.connections)
    entry.connection.from = without_surrogate(scenario, entry.connection.from);
  if (apart.judge) apart.judge->quantity = without_surrogate(scenario, apart.judge->quantity);
  apart.plots.clear(), apart.recording.ports.clear();
  return apart;
}

}  // namespace tandem::scenario
