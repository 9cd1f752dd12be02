// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/advice/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "tandem/charts/csv_table.hpp"
#include "tandem/error.hpp"
#include "tandem/scenario/steps.hpp"
#include "tandem/stability/modes.hpp"
#include "tandem/study/standing.hpp"

namespace tandem::advice {
namespace {

auto cost(const Choice& one) { return std::tuple(one.exchanges, one.own_steps, one.error); }

/// Sorted by error; each group within 1 % of its smallest by cost.
void rank(std::vector<Choice>& all) {
  constexpr double alike = 1.01;
  std::stable_sort(all.begin(), all.end(),
                   [](const Choice& a, const Choice& b) { return a.error < b.error; });
  for (auto first = all.begin(); first != all.end();) {
    const double most = alike * first->error;
    const auto last = std::find_if(first, all.end(), [&](const Choice& one) { return one.error > most; });
    std::stable_sort(first, last, [](const Choice& a, const Choice& b) { return cost(a) < cost(b); });
    first = last;
  }
}

/// Parameters that differ from those of the scenario: own steps.
std::string changed(const scenario::SubsystemEntry& now, const scenario::SubsystemEntry& before) {
  std::string text;
  for (const auto& parameter : now.parameters) {
    const auto same = std::find_if(
        before.parameters.begin(), before.parameters.end(),
        [&](const auto& other) { return other.name == parameter.name && other.value == parameter.value; });
    if (const double* number = std::get_if<double>(&parameter.value);
        number && same == before.parameters.end())
      text += fmt::format("{} = {}\n", parameter.name, *number);
  }
  return text.empty() ? "" : fmt::format("\n[subsystems.{}.parameters]\n{}", now.name, text);
}

std::string percent(double part) {
  return std::abs(part) < 1e-4
             ? "stays as it is"
             : fmt::format("{} by {:.2g} %", part > 0.0 ? "grows" : "dies out", 100.0 * std::abs(part));
}

}  // namespace

std::optional<Choice> Ranking::cheapest() const {
  std::optional<Choice> best;
  for (const Choice& one : choices)
    if (one.error <= 1.0 && (!best || cost(one) < cost(*best))) best = one;
  return best;
}

Ranking ranking(const std::filesystem::path& file) {
  const auto table = charts::CsvTable::read(
      file, {"schedule", "reconstruction", "steps", "error", "exchanges", "own_steps", "status"});
  Ranking all;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    if (row.text("status") != "ok" || !std::isfinite(row.number("error"))) {
      ++all.others;
      continue;
    }
    all.choices.push_back({row.text("schedule"), row.text("reconstruction"), row.number("steps"),
                           row.number("error"), row.number("exchanges"), row.number("own_steps")});
  }
  rank(all.choices);
  return all;
}

scenario::Scenario chosen(const Choice& choice, const scenario::Scenario& scenario,
                          const std::vector<std::string>& overrides, const Builtins& builtins) {
  auto all = overrides;
  all.push_back("coordination.schedule=" + choice.schedule);
  for (const std::string& to : study::free_connections(scenario, builtins))
    all.push_back(fmt::format("connections[{}].reconstruction={}", to, choice.reconstruction));
  auto result = scenario::read(scenario.file, all);
  if (choice.steps != 1.0) scenario::scale_steps(result, builtins, choice.steps);
  return result;
}

std::string lines(const Choice& choice, const scenario::Scenario& scenario,
                  const std::vector<std::string>& overrides, const Builtins& builtins) {
  const auto result = chosen(choice, scenario, overrides, builtins);
  std::string text = fmt::format("[coordination]\nschedule = \"{}\"\n", choice.schedule);
  if (const auto& step = result.coordination.communication_step; step && choice.steps != 1.0)
    text += fmt::format("communication_step = {}\n", *step);
  const auto free = study::free_connections(scenario, builtins);
  for (const auto& entry : scenario.connections)
    if (std::find(free.begin(), free.end(), entry.connection.to) != free.end())
      text += fmt::format("\n[[connections]]\nfrom = \"{}\"\nto = \"{}\"\nreconstruction = \"{}\"\n",
                          entry.connection.from, entry.connection.to, choice.reconstruction);
  for (std::size_t k = 0; k < result.subsystems.size(); ++k)
    text += changed(result.subsystems[k], scenario.subsystems[k]);
  return text;
}

std::string reason(const scenario::Scenario& chosen, const Builtins& builtins) try {
  const auto found = stability::stability(chosen, builtins);
  if (found.modes.empty() || found.modes.front().frequency <= 0.0) return "";
  const stability::Mode& fastest = found.modes.front();
  const double largest = found.step.period / static_cast<double>(*std::min_element(found.step.steps.begin(),
                                                                                   found.step.steps.end()));
  std::string text =
      fmt::format("fastest mode {:.4g} Hz ({}), {:.3g} of the largest steps a cycle", fastest.frequency,
                  found.mostly(fastest), 1.0 / (fastest.frequency * largest));
  if (!fastest.is_kept()) return text + ", and the scheme has no mode like it";
  const double omega =
      2.0 * std::numbers::pi * fastest.frequency / std::sqrt(1.0 - fastest.damping * fastest.damping);
  const double rate = omega * (fastest.damping - fastest.scheme_damping);
  return text + fmt::format(", where the scheme's amplitude {} over the run beside the true one",
                            percent(std::expm1(std::min(rate * (chosen.stop - chosen.start), 50.0))));
} catch (const Error&) {
  return "";
}

}  // namespace tandem::advice
