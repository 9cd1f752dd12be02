// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "view/plots.hpp"

#include <algorithm>
#include <set>

namespace tandem::view {
namespace {

constexpr std::size_t plots_in_sight = 4;

/// The entity that a column is a coordinate of, if it is no output of the file; null otherwise.
const mbs::Entity* entity_of(const Run& run, const std::string& column) {
  if (column.size() < 3 || column[column.size() - 2] != '.') return nullptr;
  for (const RunMechanism& m : run.mechanisms) {
    if (!column.starts_with(m.instance + ".")) continue;
    const std::string own = column.substr(m.instance.size() + 1), name = own.substr(0, own.size() - 2);
    const auto& outputs = m.description.outputs;
    if (std::any_of(outputs.begin(), outputs.end(), [&](const mbs::Output& o) { return o.name == own; }))
      return nullptr;
    for (const mbs::Entity& entity : m.description.entities)
      if (entity.name == name) return &entity;
  }
  return nullptr;
}

bool is_indicator(const std::string& column) {
  return column.starts_with("defect(") || column.starts_with("energy(");
}

std::vector<std::string> asked_for(const Run& run) {
  std::vector<std::string> names;
  if (!run.about.contains("scenario")) return names;
  const auto& values = run.about.at("scenario").at("values");
  if (!values.contains("dimension") && values.contains("view") && values["view"].contains("plots"))
    return values["view"]["plots"].get<std::vector<std::string>>();
  for (const RunMechanism& m : run.mechanisms)
    for (const std::string& name : m.view.plots) names.push_back(m.instance + "." + name);
  return names;
}

/// Judged quantity, one of each unit, the others, positions.
std::vector<std::string> by_interest(const Run& run) {
  std::vector<std::string> first, rest, positions;
  if (run.about.contains("scenario"))
    if (const auto& values = run.about.at("scenario").at("values"); values.contains("judge"))
      first.push_back(values["judge"].value("quantity", ""));
  std::set<std::string> units;
  for (const text::TimeTable& table : run.tables)
    for (const std::string& name : table.names)
      if (!is_indicator(name))
        (drawn_only(run, name)                 ? positions
         : units.insert(run.unit(name)).second ? first
                                               : rest)
            .push_back(name);
  first.insert(first.end(), rest.begin(), rest.end());
  return first.empty() ? positions : first;
}

}  // namespace

bool drawn_only(const Run& run, const std::string& column) { return entity_of(run, column) != nullptr; }

bool stands_still(const Run& run, const std::string& column) {
  const mbs::Entity* entity = entity_of(run, column);
  return entity && entity->fixed;
}

std::vector<std::string> plots_at_first(const Run& run) {
  std::vector<std::string> chosen;
  const auto asked = asked_for(run);
  std::set<std::string> seen;
  for (const std::string& name : asked.empty() ? by_interest(run) : asked) {
    if (asked.empty() && chosen.size() == plots_in_sight) break;
    if (run.has(name) && !stands_still(run, name) && seen.insert(name).second) chosen.push_back(name);
  }
  for (const std::string& name : run.indicators)
    if (run.has(name)) chosen.push_back(name);
  return chosen;
}

}  // namespace tandem::view
