// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "standing_metrics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace tandem::study {
namespace {

std::string column(const JudgedOutput& output) {
  std::string name = output.name + "_error";
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

std::string difference(const JudgedOutput& one) {
  const bool rms = one.measure.norm == scenario::Norm::rms;
  std::string text = fmt::format("{} = {{ of = \"{}\", norm = \"{}\", relative = \"{}\"", column(one),
                                 one.name, rms ? "rms" : "max", rms ? "rms" : "peak");
  if (std::isfinite(one.measure.from)) text += fmt::format(", from = {}", one.measure.from);
  if (std::isfinite(one.measure.to)) text += fmt::format(", to = {}", one.measure.to);
  if (one.measure.shift > 0.0) text += fmt::format(", shift = {}", one.measure.shift);
  return text + " }\n";
}

}  // namespace

std::string standing_metrics(const std::vector<JudgedOutput>& judged, const scenario::Scenario& scenario,
                             bool is_judged) {
  std::string text = "\n[metrics]\n";
  std::vector<std::string> fractions, floors, steps;
  for (const JudgedOutput& one : judged) {
    text += difference(one);
    fractions.push_back(fmt::format("{}/{}", column(one), one.tolerance));
    floors.push_back(fmt::format("{}.floor/{}", column(one), one.tolerance));
  }
  for (const auto& entry : scenario.subsystems) {
    text += fmt::format("\"steps.{}\" = {{}}\n", entry.name);
    steps.push_back("steps." + entry.name);
  }
  text += fmt::format(
      "exchanges = {{}}\nown_steps = {{ formula = \"{}\" }}\nerror = {{ formula = \"max({})\" }}\n",
      fmt::join(steps, " + "), fmt::join(fractions, ", "));
  return text + (is_judged
                     ? fmt::format("reference_error = {{ formula = \"max({})\" }}\n", fmt::join(floors, ", "))
                     : "");
}

std::string standing_charts(bool is_judged) {
  return fmt::format(R"toml(
[names]
error = "error / tolerance"
steps = "steps x"
own_steps = "own steps"

[[charts]]
name = "schemes_work"
kind = "work"
title = "Error against cost"
cost = ["exchanges", "own_steps"]
error = "error"
{}colour = "schedule"
marker = "reconstruction"
front = true
tolerance = 1

[[charts]]
name = "schemes_map"
kind = "map"
title = "Error as a part of the tolerance"
rows = ["schedule", "reconstruction"]
columns = "steps"
value = "error"
limits = [0.01, 0.1, 0.5, 1, 10]
best = 1
)toml",
                     is_judged ? "floor = \"reference_error\"\n" : "");
}

}  // namespace tandem::study
