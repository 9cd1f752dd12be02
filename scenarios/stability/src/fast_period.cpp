// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/stability/fast_period.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <numbers>

#include "tandem/error.hpp"
#include "tandem/scenario/taken.hpp"
#include "trial.hpp"
#include "undivided.hpp"

namespace tandem::stability {
namespace {

/// [s]
double shortest_period(const scenario::Scenario& scenario, const Builtins& builtins) {
  const Trial trial(scenario, builtins);
  const Eigen::MatrixXd rates = undivided(trial, false).rates;
  const double fastest =
      rates.size() > 0 ? Eigen::EigenSolver<Eigen::MatrixXd>(rates, false).eigenvalues().imag().maxCoeff()
                       : 0.0;
  if (!(fastest > 0.0)) throw Error(ErrorCode::not_supported, "the system undivided does not swing");
  return 2.0 * std::numbers::pi / fastest;
}

/// The slow side's output that one of a surrogate stands for; else the same.
std::string without_surrogate(const scenario::Scenario& scenario, const std::string& output) {
  for (const auto& entry : scenario.subsystems) {
    if (!entry.impulse) continue;
    const auto& links = entry.impulse->links;
    for (std::size_t k = 0; k < links.size(); ++k) {
      const std::string number = links.size() > 1 ? fmt::format("_{}", k + 1) : "";
      if (output == entry.name + ".displacement" + number) return links[k].displacement;
      const auto& velocity = links[k].effective.velocity;
      if (velocity && output == entry.name + ".velocity" + number) return *velocity;
    }
  }
  return output;
}

}  // namespace

scenario::Scenario by_signals(const scenario::Scenario& scenario) {
  auto apart = scenario::with_usual(scenario::with_taken(scenario, {"coordination.coupling=signals"}));
  for (auto& entry : apart.connections)
    entry.connection.from = without_surrogate(scenario, entry.connection.from);
  if (apart.judge) apart.judge->quantity = without_surrogate(scenario, apart.judge->quantity);
  apart.plots.clear(), apart.recording.ports.clear();
  return apart;
}

scenario::Scenario with_fast_period(scenario::Scenario scenario, const Builtins& builtins) {
  if (!scenario::lacks_fast_period(scenario)) return scenario;
  try {
    scenario::take_fast_period(scenario, shortest_period(by_signals(scenario), builtins));
  } catch (const Error& error) {
    scenario::refuse(
        scenario.place("coordination.coupling"),
        fmt::format("coordination.fast_period is not stated, and can't be found: {}; allowed is a "
                    "number above 0 [s]",
                    error.what()),
        error.code());
  }
  return scenario;
}

}  // namespace tandem::stability
