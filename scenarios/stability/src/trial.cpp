// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "trial.hpp"

#include <fmt/format.h>

#include <limits>

namespace tandem::stability {
namespace {

scenario::Scenario with_data_of_start(scenario::Scenario scenario) {
  for (scenario::SubsystemEntry& entry : scenario.subsystems)
    for (scenario::InputEntry& input : entry.inputs) {
      if (const auto* data = std::get_if<1>(&input.value)) (*data)->require(scenario.start);
      input.value = input.at(scenario.start);
    }
  return scenario;
}

}  // namespace

Trial::Trial(const scenario::Scenario& scenario, const Builtins& builtins)
    : scenario_(with_data_of_start(scenario)),
      parts_(scenario_, builtins, scenario::Code::run),
      coordination_(parts_.coordination()) {
  coordination_.start = StartKind::cold;
  coordination_.diverged_beyond = std::numeric_limits<double>::infinity();
  for (int i = 0; i < parts_.topology().size(); ++i) {
    const SubsystemInfo& info = parts_.topology().info(i);
    if (!info.abilities.restarts) refuse(i, "can't start again");
  }
  begin();
}

void Trial::refuse(int instance, const std::string& what) const {
  scenario::refuse(scenario_.subsystems[static_cast<std::size_t>(instance)].place,
                   fmt::format("subsystem '{}' {}", parts_.topology().name(instance), what),
                   ErrorCode::not_supported);
}

/// Each subsystem with its part of z.
void Trial::seed(const Eigen::VectorXd& z) {
  std::vector<std::vector<double>> states;
  std::vector<std::vector<std::vector<double>>> past;
  for (int i = 0; i < topology().size(); ++i) {
    const auto width = static_cast<std::size_t>(topology().info(i).row_size() - Samples::header);
    states.emplace_back(this->states(i).size());
    past.emplace_back(static_cast<std::size_t>(ages_[static_cast<std::size_t>(i)]),
                      std::vector<double>(width));
  }
  for (const auto& [instance, row] : given_) past[static_cast<std::size_t>(instance)][0] = row;
  for (Eigen::Index k = 0; k < z.size(); ++k) {
    const Coordinate& c = coordinates_[static_cast<std::size_t>(k)];
    const auto i = static_cast<std::size_t>(c.subsystem), index = static_cast<std::size_t>(c.index);
    (c.age < 0 ? states[i] : past[i][static_cast<std::size_t>(c.age)])[index] = z[k];
  }
  for (std::size_t i = 0; i < seeded_.size(); ++i) seeded_[i]->seed(std::move(past[i]), std::move(states[i]));
}

Eigen::VectorXd Trial::after(const Eigen::VectorXd& z) {
  seed(z);
  std::vector<Subsystem*> all;
  for (const auto& one : seeded_) all.push_back(one.get());
  Coordinator(topology(), all, coordination_, span_).run();
  std::vector<std::vector<double>> states;
  for (std::size_t i = 0; i < seeded_.size(); ++i)
    seeded_[i]->get_states(states.emplace_back(states_[i].size()));
  Eigen::VectorXd end(z.size());
  for (Eigen::Index k = 0; k < end.size(); ++k) {
    const Coordinate& c = coordinates_[static_cast<std::size_t>(k)];
    const auto i = static_cast<std::size_t>(c.subsystem);
    end[k] = c.age < 0 ? states[i][static_cast<std::size_t>(c.index)] : seeded_[i]->sample(c.age, c.index);
  }
  return end;
}

}  // namespace tandem::stability
