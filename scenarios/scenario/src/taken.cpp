// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/taken.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
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
  if (key == "coordination.schedule" || key == "coordination.order" || key == "coordination.coupling" ||
      key == "coordination.carrier")
    return true;
  if (key.starts_with("connections[") && key.ends_with("].reconstruction")) return true;
  return is_number(value) &&
         (key == "coordination.communication_step" || key == "coordination.fast_period" ||
          (key.starts_with("subsystems.") && key.find(".parameters.") != std::string::npos));
}

/// Of one that has been taken.
void remark_on_period(Scenario& scenario) {
  if (std::any_of(scenario.taken.begin(), scenario.taken.end(),
                  [](const std::string& one) { return one.starts_with("coordination.fast_period="); }))
    scenario.remarks.push_back(fmt::format(
        "coordination.fast_period is {:.6g} s, the shortest of the system undivided", scenario.fast_period));
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
                 "'; allowed are a schedule, an order, a coupling, its carrier and period, reconstructions "
                 "and numbers of "
                 "steps");
  taken.insert(taken.begin(), scenario.taken.begin(), scenario.taken.end());
  auto all = scenario.overrides;
  all.insert(all.end(), taken.begin(), taken.end());
  all.emplace_back("coordination.scheme=stated");
  Scenario result = read(scenario.file, all);
  result.overrides = scenario.overrides, result.taken = std::move(taken);
  remark_on_period(result);
  return result;
}

void take_fast_period(Scenario& scenario, double period) {
  auto values = nlohmann::ordered_json::parse(scenario.values);
  values["coordination"]["fast_period"] = period;
  scenario.values = values.dump();
  scenario.fast_period = period;
  scenario.taken.push_back(fmt::format("coordination.fast_period={:#}", period));
  remark_on_period(scenario);
}

}  // namespace tandem::scenario
