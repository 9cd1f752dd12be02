// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/taken.hpp"

#include <cmath>
#include <stdexcept>

#include "tandem/printable.hpp"

namespace tandem::scenario {
namespace {

bool is_number(const std::string& text) {
  std::size_t end = 0;
  try {
    return std::isfinite(std::stod(text, &end)) && end == text.size();
  } catch (const std::logic_error&) {
    return false;
  }
}

/// Keys of a scheme alone: what is taken may come from a file.
bool is_of_a_scheme(const std::string& taken) {
  const auto equals = taken.find('=');
  const std::string key = taken.substr(0, equals),
                    value = equals < taken.size() ? taken.substr(equals + 1) : "";
  if (key == "coordination.schedule" || key == "coordination.order" || key == "coordination.coupling")
    return true;
  if (key.starts_with("connections[") && key.ends_with("].reconstruction")) return true;
  return is_number(value) &&
         (key == "coordination.communication_step" || key == "coordination.fast_period" ||
          (key.starts_with("subsystems.") && key.find(".parameters.") != std::string::npos));
}

}  // namespace

Scenario with_usual(Scenario scenario) {
  scenario.chooses = false;
  scenario.otherwise = Reconstruction::parse("lagrange1");
  return scenario;
}

Scenario with_taken(const Scenario& scenario, std::vector<std::string> taken) {
  for (const std::string& one : taken)
    if (!is_of_a_scheme(one))
      refuse(scenario.place("coordination.scheme"),
             "coordination.scheme = auto took '" + printable(one, 200) +
                 "'; allowed are a schedule, an order, a coupling, its period, reconstructions and numbers of "
                 "steps");
  taken.insert(taken.begin(), scenario.taken.begin(), scenario.taken.end());
  auto all = scenario.overrides;
  all.insert(all.end(), taken.begin(), taken.end());
  all.emplace_back("coordination.scheme=stated");
  Scenario result = read(scenario.file, all);
  result.overrides = scenario.overrides, result.taken = std::move(taken);
  return result;
}

}  // namespace tandem::scenario
