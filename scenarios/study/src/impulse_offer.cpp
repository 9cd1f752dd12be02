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

bool is_of_link(const scenario::Scenario& scenario, const std::string& to) {
  const auto of_link = [](const scenario::LinkEntry& one, const std::string& from) {
    return from == one.link.effort || from == one.link.back || from == one.effective.velocity;
  };
  return std::any_of(scenario.connections.begin(), scenario.connections.end(), [&](const auto& entry) {
    return entry.connection.to == to &&
           std::any_of(scenario.links.begin(), scenario.links.end(),
                       [&](const auto& one) { return of_link(one, entry.connection.from); });
  });
}

}  // namespace tandem::study
