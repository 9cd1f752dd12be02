// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "run_indicators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/output/files.hpp"

namespace tandem::scenario {
namespace {

using Json = nlohmann::ordered_json;
using Connection = Indicators::Connection;
using Link = Indicators::Link;

/// Of the input's peak; 0 where that is 0.
double part(const Connection& one) { return one.peak > 0.0 ? one.largest / one.peak : 0.0; }
double part(const Link& one) { return one.passed > 0.0 ? std::abs(one.energy) / one.passed : 0.0; }

template <class List>
auto worst(const List& all) {
  return std::max_element(all.begin(), all.end(),
                          [](const auto& a, const auto& b) { return part(a) < part(b); });
}

/// "fast.x2" of "defect(fast.x2)".
std::string inner(const std::string& name) {
  const auto at = name.find('(') + 1;
  return name.substr(at, name.size() - at - 1);
}

}  // namespace

void write_indicators(const std::filesystem::path& file, const Indicators& indicators,
                      const Estimate* estimate, double time) {
  std::string text = "time";
  for (const Connection& one : indicators.connections()) text += "," + one.name;
  for (const Link& one : indicators.links()) text += "," + one.name;
  if (estimate) text += "," + estimate->name();
  text += "\n";
  const auto add_largest = [&text](double value) {
    text += ",";
    if (!(value < 0.0)) fmt::format_to(std::back_inserter(text), "{}", value);
  };
  std::vector<double> energies(indicators.links().size());
  const auto times = indicators.times();
  for (std::size_t k = 0; k < times.size() && (k == 0 || times[k - 1] < time); ++k) {
    fmt::format_to(std::back_inserter(text), "{}", std::min(times[k], time));
    for (const Connection& one : indicators.connections()) add_largest(one.windows[k]);
    for (std::size_t i = 0; i < energies.size(); ++i)
      fmt::format_to(std::back_inserter(text), ",{}", energies[i] += indicators.links()[i].windows[k]);
    if (estimate) add_largest(k < estimate->windows().size() ? estimate->windows()[k] : -1.0);
    text += "\n";
  }
  output::replace_text(file, text);
}

void add_figures(const Indicators& indicators, const Estimate* estimate, Json& results) {
  Json &units = results["units"], defects = Json::object(), energies = Json::object();
  for (const Connection& one : indicators.connections()) {
    defects[one.name] = {{"largest", one.largest}, {"at", one.at}, {"peak_of_input", one.peak}};
    units[one.name] = one.unit;
  }
  for (const Link& one : indicators.links()) {
    energies[one.name] = {{"made", one.energy}, {"passed", one.passed}};
    units[one.name] = "J";
  }
  results["indicators"] = {{"defects", defects}, {"energies", energies}};
  if (!estimate) return;
  units[estimate->name()] = estimate->unit();
  results["indicators"]["estimates"] = {{estimate->name(), estimate->figures()}};
}

std::string told_by(const Indicators& indicators) {
  std::string text;
  if (const auto one = worst(indicators.connections());
      one != indicators.connections().end() && one->peak > 0.0)
    text += fmt::format("largest defect {:.2g} of the input's peak ({}, t = {:.4g} s)", part(*one),
                        inner(one->name), one->at);
  if (const auto one = worst(indicators.links()); one != indicators.links().end() && one->passed > 0.0)
    text += fmt::format("{}the coupling {} {:.3g} J of {:.3g} J that passed ({})", text.empty() ? "" : "; ",
                        one->energy < 0.0 ? "lost" : "made", std::abs(one->energy), one->passed,
                        inner(one->name));
  return text;
}

}  // namespace tandem::scenario
