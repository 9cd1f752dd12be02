// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "scaled_steps.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tandem/scenario/steps.hpp"

namespace tandem::study {
namespace {

/// All that first own steps go by: the scenario as it stands, but for what only couples its subsystems later.
std::string key_of(const scenario::Scenario& scenario, double factor) {
  auto values = nlohmann::json::parse(scenario.values);
  if (auto it = values.find("coordination"); it != values.end())
    for (const char* name : {"schedule", "order", "communication_step"}) it->erase(name);
  if (auto it = values.find("connections"); it != values.end())
    for (auto& one : *it) one.erase("reconstruction");
  return fmt::format("{}\n{}\n{}", scenario.file.string(), factor, values.dump());
}

}  // namespace

void ScaledSteps::scale(scenario::Scenario& scenario, double factor) {
  if (scenario::by_impulse(scenario)) return scenario::scale_steps(scenario, builtins_, factor);
  const std::string key = key_of(scenario, factor);
  const std::lock_guard lock(mutex_);
  const auto known = known_.find(key);
  if (known == known_.end()) {
    scenario::scale_steps(scenario, builtins_, factor);
    auto& all = known_[key];
    for (const auto& entry : scenario.subsystems) all.push_back(entry.parameters);
    return;
  }
  if (auto& step = scenario.coordination.communication_step) *step *= factor;
  for (std::size_t k = 0; k < scenario.subsystems.size(); ++k)
    scenario.subsystems[k].parameters = known->second[k];
}

}  // namespace tandem::study
