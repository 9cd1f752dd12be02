// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/advice/expected.hpp"

#include <algorithm>
#include <chrono>

#include "tandem/error.hpp"
#include "tandem/identification/models.hpp"
#include "tandem/scenario/by_signals.hpp"
#include "tandem/scenario/steps.hpp"
#include "tandem/scenario/traces.hpp"

namespace tandem::advice {
namespace {

using scenario::Assembly;
using scenario::Scenario;

/// Cubic, by derivatives where there are any; what is held or late stays.
void reconstruct(Scenario& scenario, const Builtins& builtins) {
  const scenario::Parts parts(scenario, builtins, scenario::Code::run);
  for (auto& entry : scenario.connections) {
    const Port* port = parts.topology().output_port(entry.connection.from);
    if (!port || port->held || entry.connection.lag != Lag::none) continue;
    entry.connection.how = Reconstruction::parse(port->derivatives > 0 ? "hermite" : "lagrange3");
  }
}

/// The scenario as its models run it.
Scenario finer(Scenario scenario, const Builtins& builtins) {
  static constexpr double part = 1.0 / 16.0;
  scenario = scenario::by_signals(scenario);
  scenario.coordination.schedule = Schedule::Kind::fastest_first;
  reconstruct(scenario, builtins);
  scenario::scale_each_step(scenario, builtins,
                            [](double own, double shortest) { return std::min(part, shortest / own); });
  return scenario;
}

/// called: its output's name. That of a surrogate has another one where no surrogate is.
text::TimeTable table_of(const Scenario& scenario, const std::string& called, const Builtins& builtins,
                         const std::function<bool()>& going) {
  const std::string& quantity = scenario.judge->quantity;
  Assembly assembly(scenario, builtins);
  scenario::Traces traces(assembly.topology(), {quantity}, "the run of models");
  assembly.coordinator().observe(&traces);
  assembly.initialize();
  while (assembly.coordinator().round())
    if (going && !going()) throw Error(ErrorCode::not_supported, "interrupted");
  text::TimeTable table = traces.of(quantity);
  for (std::string& name : table.names) name.replace(name.find(quantity), quantity.size(), called);
  return table;
}

}  // namespace

scenario::Expectation expected(const Scenario& scenario, const Builtins& builtins,
                               const std::function<bool()>& going) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  scenario::Expectation all;
  try {
    if (scenario.judge->measure.shift > 0.0)
      throw Error(ErrorCode::not_supported, "[judge] lets the output be late as a whole");
    identification::Models models(identification::Models::Without::refused);
    const Builtins modelled = models.replacing(builtins);
    all.table = table_of(finer(scenario, modelled), scenario.judge->quantity, modelled, going);
  } catch (const Error& error) {
    all.why_not = error.what();
  }
  all.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return all;
}

}  // namespace tandem::advice
