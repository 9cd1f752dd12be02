// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tandem/scenario/assembly.hpp"
#include "tandem/scenario/shortest_step.hpp"

namespace tandem::scenario {
namespace {

constexpr double tolerance = 1e-9;  // relative: a step from a rate, 1/n, is rounded

bool is_near(double a, double b) { return std::abs(a - b) <= tolerance * std::abs(b); }

/// An own step is the difference of two times, from the start of a run on [s].
bool is_step(double own, double wanted, double start) {
  return std::abs(own - wanted) <=
         tolerance * wanted + 4.0 * std::numeric_limits<double>::epsilon() * (std::abs(start) + wanted);
}

/// First own steps [s], NaN of a sampled subsystem.
std::vector<double> own_steps(const Scenario& scenario, const Builtins& builtins) {
  Assembly assembly(scenario, builtins);
  assembly.initialize();
  std::vector<double> steps;
  for (int i = 0; i < assembly.topology().size(); ++i) {
    const bool sampled = assembly.topology().info(i).abilities.sampled;
    const double h = assembly.coordinator().own_step(i);
    steps.push_back(sampled ? std::nan("") : scenario.start == 0.0 ? h : shortest_step(h, scenario.start));
  }
  return steps;
}

void set(SubsystemEntry& entry, const std::string& name, double value) {
  const auto it = std::find_if(entry.parameters.begin(), entry.parameters.end(),
                               [&](const Parameter& p) { return p.name == name; });
  if (it != entry.parameters.end())
    it->value = value;
  else
    entry.parameters.push_back({name, value, entry.place});
}

struct Candidate {
  std::string name;
  double value;
};

/// Parameters that may make its own step, with what would make another one.
std::vector<Candidate> candidates(const SubsystemEntry& entry, const Builtins& builtins, double from,
                                  double to) {
  std::vector<Candidate> all;
  const bool takes_step = takes(entry, builtins, "step");
  if (takes_step) all.push_back({"step", to});
  for (const Parameter& p : entry.parameters) {
    const auto* number = std::get_if<double>(&p.value);
    if (!number || (takes_step && p.name == "step")) continue;
    if (is_near(*number, from)) all.push_back({p.name, to});
    if (p.name.starts_with("steps_per_")) all.push_back({p.name, *number * from / to});
  }
  constexpr const char* of_model =
      "model_step";  // a linear model in the place of a subsystem (identification)
  if (takes(entry, builtins, of_model)) all.push_back({of_model, to});
  return all;
}

/// There nothing else may set it.
void refuse_in_address(const SubsystemEntry& entry) {
  if (query_of(entry.source).has("step"))
    refuse(entry.source_place,
           fmt::format("the step of subsystem '{}' stands in its source, where it can't be "
                       "made another one; allowed is subsystems.{}.parameters.step",
                       entry.name, entry.name));
}

/// Likewise by a parameter steps_per_.. of its source that the scenario leaves out: its own step by one value tells another.
std::optional<Scenario> with_rate(const Scenario& scenario, std::size_t which, const Builtins& builtins,
                                  double to) {
  constexpr double trial = 100.0;
  const SubsystemEntry& entry = scenario.subsystems[which];
  for (const Word& word : source_of(entry.source, builtins).words) {
    const bool is_given = std::ranges::count(entry.parameters, word.name, &Parameter::name) > 0;
    if (is_given || !word.name.starts_with("steps_per_")) continue;
    Scenario other = scenario;
    set(other.subsystems[which], word.name, trial);
    set(other.subsystems[which], word.name, trial * own_steps(other, builtins)[which] / to);
    if (is_step(own_steps(other, builtins)[which], to, scenario.start)) return other;
  }
  return {};
}

/// The scenario with another own step of one subsystem; nothing if no parameter makes it.
std::optional<Scenario> with_step(const Scenario& scenario, std::size_t which, const Builtins& builtins,
                                  double from, double to) {
  for (const auto& [name, value] : candidates(scenario.subsystems[which], builtins, from, to)) {
    Scenario other = scenario;
    set(other.subsystems[which], name, value);
    if (is_step(own_steps(other, builtins)[which], to, scenario.start)) return other;
  }
  return with_rate(scenario, which, builtins, to);
}

/// Those that have one of their own: a surrogate of an impulse coupling goes by its fast side's. The slow side's stays longer
/// all the while.
std::vector<std::size_t> in_order(const Scenario& scenario, const std::vector<double>& steps, bool grow) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (!std::isnan(steps[i]) && !scenario.subsystems[i].impulse) order.push_back(i);
  if (by_impulse(scenario))
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return grow ? steps[a] > steps[b] : steps[a] < steps[b];
    });
  return order;
}

}  // namespace

void scale_each_step(Scenario& scenario, const Builtins& builtins,
                     const std::function<double(double own, double shortest)>& factor) {
  const auto steps = own_steps(scenario, builtins);
  double shortest = std::numeric_limits<double>::infinity();
  for (const double step : steps) shortest = std::fmin(shortest, step);
  for (const std::size_t i : in_order(scenario, steps, factor(shortest, shortest) > 1.0)) {
    refuse_in_address(scenario.subsystems[i]);
    const double by = factor(steps[i], shortest);
    auto other = with_step(scenario, i, builtins, steps[i], steps[i] * by);
    if (!other)
      refuse(
          scenario.subsystems[i].place,
          fmt::format("subsystem '{}' has an own step of {} s, and no parameter of it is known to make it "
                      "{} s; allowed is "
                      "one whose value in the scenario is that of the own step, or one named steps_per_...",
                      scenario.subsystems[i].name, steps[i], steps[i] * by));
    scenario = std::move(*other);
  }
}

void scale_known_steps(Scenario& scenario, const Builtins& builtins, double factor) {
  if (auto& step = scenario.coordination.communication_step) *step *= factor;
  const auto steps = own_steps(scenario, builtins);
  for (const std::size_t i : in_order(scenario, steps, factor > 1.0))
    if (auto other = with_step(scenario, i, builtins, steps[i], steps[i] * factor))
      scenario = std::move(*other);
}

void scale_steps(Scenario& scenario, const Builtins& builtins, double factor) {
  if (auto& step = scenario.coordination.communication_step) *step *= factor;
  scale_each_step(scenario, builtins, [factor](double, double) { return factor; });
}

std::vector<ChangedStep> changed_steps(const Scenario& scenario, const Scenario& scaled) {
  std::vector<ChangedStep> all;
  for (std::size_t k = 0; k < scaled.subsystems.size(); ++k)
    for (const Parameter& now : scaled.subsystems[k].parameters) {
      const auto& before = scenario.subsystems[k].parameters;
      const auto is_as_now = [&](const Parameter& one) {
        return one.name == now.name && one.value == now.value;
      };
      const double* number = std::get_if<double>(&now.value);
      if (number && std::none_of(before.begin(), before.end(), is_as_now))
        all.push_back({scaled.subsystems[k].name, now.name, *number});
    }
  return all;
}

bool can_scale_steps(const Scenario& scenario, const Builtins& builtins) {
  Scenario other = scenario;
  try {
    scale_steps(other, builtins, 0.5);
    return true;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::invalid_argument) throw;
    return false;
  }
}

bool states_steps(const Scenario& scenario, const Builtins& builtins) {
  if (scenario.coordination.communication_step) return true;
  Scenario other = scenario;
  scale_steps(other, builtins, 0.5);
  const auto is_as_before = [](const SubsystemEntry& now, const SubsystemEntry& before) {
    return now.parameters.size() != before.parameters.size() ||
           std::equal(now.parameters.begin(), now.parameters.end(), before.parameters.begin(),
                      [](const Parameter& a, const Parameter& b) { return a.value == b.value; });
  };
  return !std::equal(other.subsystems.begin(), other.subsystems.end(), scenario.subsystems.begin(),
                     is_as_before);
}

}  // namespace tandem::scenario
