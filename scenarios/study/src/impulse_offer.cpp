// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/study/impulse_offer.hpp"

#include <algorithm>

#include "tandem/error.hpp"
#include "tandem/scenario/parts.hpp"
#include "tandem/scenario/taken.hpp"
#include "tandem/stability/fast_period.hpp"

namespace tandem::study {

std::vector<std::string> impulse_overrides() {
  return {"coordination.coupling=impulse", "coordination.schedule=fastest-first"};
}

ImpulseOffer impulse_offer(const scenario::Scenario& scenario, const Builtins& builtins) try {
  const auto coupled = stability::with_fast_period(
      scenario::with_usual(scenario::with_taken(scenario, impulse_overrides())), builtins);
  scenario::Parts(coupled, builtins, scenario::Code::run);
  return {coupled.fast_period};
} catch (const Error& error) {
  return {0.0, error.what()};
}

bool is_back_of_link(const scenario::Scenario& scenario, const std::string& output) {
  return std::any_of(scenario.links.begin(), scenario.links.end(), [&](const scenario::LinkEntry& one) {
    return output == one.link.back || output == one.effective.velocity;
  });
}

bool is_of_link(const scenario::Scenario& scenario, const std::string& to) {
  const auto is_effort = [&](const std::string& from) {
    return std::any_of(scenario.links.begin(), scenario.links.end(),
                       [&](const scenario::LinkEntry& one) { return from == one.link.effort; });
  };
  return std::any_of(scenario.connections.begin(), scenario.connections.end(), [&](const auto& entry) {
    const std::string& from = entry.connection.from;
    return entry.connection.to == to && (is_effort(from) || is_back_of_link(scenario, from));
  });
}

}  // namespace tandem::study
