// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/advice/advice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <tuple>

#include "tandem/charts/csv_table.hpp"
#include "tandem/error.hpp"
#include "tandem/scenario/steps.hpp"
#include "tandem/stability/fast_period.hpp"
#include "tandem/stability/modes.hpp"
#include "tandem/study/impulse_offer.hpp"
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

/// The columns order_0, ..
std::vector<std::string> order_of(const charts::CsvTable& table, std::size_t row) {
  std::vector<std::string> order;
  for (std::string name = "order_0"; table.has(name); name = fmt::format("order_{}", order.size()))
    order.push_back(table[row].text(name));
  return order;
}

std::string as_toml(const std::vector<std::string>& order) {
  return fmt::format("[\"{}\"]", fmt::join(order, "\", \""));
}

/// The steps of a choice, where they are not those of the scenario.
struct Steps {
  std::optional<double> communication;
  std::vector<scenario::ChangedStep> own;
};

Steps steps_of(const Choice& choice, const scenario::Scenario& scenario, const Builtins& builtins) {
  Steps all;
  if (choice.steps == 1.0) return all;
  scenario::Scenario scaled = scenario;
  scenario::scale_steps(scaled, builtins, choice.steps);
  all.communication = scaled.coordination.communication_step;
  all.own = scenario::changed_steps(scenario, scaled);
  return all;
}

/// Over a link that is coupled by impulse goes no reconstruction.
std::vector<std::size_t> free_of(const Choice& choice, const scenario::Scenario& scenario,
                                 const Builtins& builtins, study::Varied varied) {
  auto all = study::free_connections(scenario, builtins, varied);
  if (choice.is_impulse())
    std::erase_if(all, [&](std::size_t k) {
      return study::is_of_link(scenario, scenario.connections[k].connection.to);
    });
  return all;
}

std::string reconstruction_of(const Choice& choice) {
  return choice.is_impulse() ? "lagrange3" : choice.reconstruction;
}

/// What the scenario states of a connection, but for its reconstruction.
std::string connection_of(const scenario::Scenario& scenario, std::size_t k) {
  const Connection& one = scenario.connections[k].connection;
  std::string text = fmt::format("\n[[connections]]\nfrom = \"{}\"\nto = \"{}\"\n", one.from, one.to);
  const auto values = nlohmann::json::parse(scenario.values);
  const nlohmann::json::json_pointer at(fmt::format("/connections/{}", k));
  if (!values.contains(at)) return text;
  for (const auto& [key, value] : values.at(at).items())
    if (key != "from" && key != "to" && key != "reconstruction")
      text += fmt::format("{} = {}\n", key, value.dump());
  return text;
}

std::string percent(double part) {
  return std::abs(part) < 1e-4
             ? "stays as it is"
             : fmt::format("{} by {:.2g} %", part > 0.0 ? "grows" : "dies out", 100.0 * std::abs(part));
}

}  // namespace

std::string override_of(const std::vector<std::string>& order) {
  return "coordination.order=" + as_toml(order);
}

std::optional<Choice> Ranking::cheapest() const {
  std::optional<Choice> best;
  for (const Choice& one : choices)
    if (one.error <= 1.0 && (!best || cost(one) < cost(*best))) best = one;
  return best;
}

std::vector<Choice> finalists(const Ranking& ranking) {
  constexpr double worth = 10.0;  // times the tolerance, as a short run says
  auto all = ranking.choices;
  std::ranges::stable_sort(all, [](const Choice& a, const Choice& b) { return cost(a) < cost(b); });
  std::vector<Choice> front;
  for (const Choice& one : all)
    if (front.empty() || one.error < front.back().error) front.push_back(one);
  const auto is_far = [](const Choice& one) { return one.error > worth; };
  front.erase(front.begin(), std::find_if_not(front.begin(), front.end() - 1, is_far));
  return front;
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
                           row.number("error"), row.number("exchanges"), row.number("own_steps"),
                           order_of(table, k)});
  }
  rank(all.choices);
  return all;
}

std::vector<std::string> taken(const Choice& choice, const scenario::Scenario& scenario,
                               const Builtins& builtins, study::Varied varied) {
  std::vector<std::string> all = {"coordination.schedule=" + choice.schedule};
  if (choice.is_impulse()) all = study::impulse_overrides(choice.reconstruction);
  if (!choice.order.empty()) all.push_back(override_of(choice.order));
  for (const std::size_t k : free_of(choice, scenario, builtins, varied))
    all.push_back(fmt::format("connections[{}].reconstruction={}", study::key_of(scenario, k),
                              reconstruction_of(choice)));
  const Steps steps = steps_of(choice, scenario, builtins);
  if (steps.communication)
    all.push_back(fmt::format("coordination.communication_step={}", *steps.communication));
  for (const auto& one : steps.own)
    all.push_back(fmt::format("subsystems.{}.parameters.{}={}", one.subsystem, one.parameter, one.value));
  return all;
}

std::string lines(const Choice& choice, const scenario::Scenario& scenario, const Builtins& builtins,
                  study::Varied varied) {
  const Steps steps = steps_of(choice, scenario, builtins);
  const std::string coupling =
      choice.is_impulse() ? fmt::format("coupling = \"{}\"\n", choice.reconstruction) : "";
  std::string text = fmt::format("[coordination]\n{}schedule = \"{}\"\n", coupling, choice.schedule);
  if (!choice.order.empty()) text += fmt::format("order = {}\n", as_toml(choice.order));
  if (steps.communication) text += fmt::format("communication_step = {}\n", *steps.communication);
  for (const std::size_t k : free_of(choice, scenario, builtins, varied))
    text += connection_of(scenario, k) + fmt::format("reconstruction = \"{}\"\n", reconstruction_of(choice));
  for (const auto& one : steps.own)
    text += fmt::format("\n[subsystems.{}.parameters]\n{} = {}\n", one.subsystem, one.parameter, one.value);
  return text;
}

std::string reason(const scenario::Scenario& chosen, const Builtins& builtins) try {
  const auto found = stability::stability(stability::with_fast_period(chosen, builtins), builtins);
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
