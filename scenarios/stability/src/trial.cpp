// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tandem/error.hpp"

namespace tandem::stability {

Trial::Trial(const scenario::Scenario& scenario, const Builtins& builtins)
    : scenario_(scenario),
      parts_(scenario, builtins, scenario::Code::run),
      coordination_(scenario.coordination) {
  coordination_.start = StartKind::cold;
  coordination_.diverged_beyond = std::numeric_limits<double>::infinity();
  for (int i = 0; i < parts_.topology().size(); ++i) {
    const SubsystemInfo& info = parts_.topology().info(i);
    if (info.states.empty()) refuse(i, "does not give its states as numbers");
    if (!info.abilities.restarts) refuse(i, "can't start again");
    if (info.abilities.sampled) refuse(i, "is sampled, which the map of a super-step does not know");
    if (info.abilities.events) refuse(i, "has events, which are no linear map");
  }
  begin();
}

void Trial::refuse(int instance, const std::string& what) const {
  scenario::refuse(scenario_.subsystems[static_cast<std::size_t>(instance)].place,
                   fmt::format("subsystem '{}' {}", parts_.topology().name(instance), what));
}

void Trial::begin() {
  const Topology& topology = parts_.topology();
  std::vector<Subsystem*> own;
  for (int i = 0; i < topology.size(); ++i) own.push_back(parts_.subsystem(i));
  Coordinator run(topology, own, coordination_, {scenario_.start, scenario_.stop});
  run.initialize();
  for (int i = 0; i < topology.size(); ++i) own_steps_.push_back(run.own_step(i));
  auto lengths = own_steps_;
  if (coordination_.communication_step && coordination_.schedule == Schedule::Kind::parallel)
    lengths.push_back(*coordination_.communication_step);
  const auto period = common_period(lengths, most_steps);
  if (!period)
    throw Error(ErrorCode::not_supported,
                fmt::format("{}: own steps of {} s have no common period of up to {} of the largest",
                            scenario_.file.string(), fmt::join(own_steps_, ", "), most_steps));
  period_ = *period;
  std::int64_t before = 1;
  for (int i = 0; i < topology.size(); ++i) {
    ages_.push_back(samples_read(i));
    const std::int64_t steps = period_.steps[static_cast<std::size_t>(i)];
    before = std::max(before, (ages_.back() + steps - 1) / steps);
    add_coordinates(i, run);
    seeded_.push_back(std::make_unique<Seeded>(*parts_.subsystem(i), scenario_.start, own_step(i)));
  }
  span_ = {scenario_.start - static_cast<double>(before) * period_.length, scenario_.start + period_.length};
  after(start_);  // so that each knows how many samples it gives up to the start
}

/// Past samples, the newest included, that a reader's segment or mean may be made of.
int Trial::samples_read(int instance) const {
  int most = 1;
  for (const int number : parts_.topology().lines_from(instance)) {
    const Line& line = parts_.topology().lines()[static_cast<std::size_t>(number)];
    double late =
        line.how.kind == Reconstruction::Kind::mean || line.lag == Lag::memory ? own_step(line.reader) : 0.0;
    if (line.lag == Lag::delay)
      late =
          coordination_.communication_step.value_or(*std::max_element(own_steps_.begin(), own_steps_.end()));
    most = std::max(most, line.how.samples() + 1 + static_cast<int>(std::ceil(late / own_step(instance))));
  }
  return most;
}

void Trial::add_coordinates(int instance, const Coordinator& run) {
  const Topology& topology = parts_.topology();
  const SubsystemInfo& info = topology.info(instance);
  std::vector<double> values(info.states.size());
  parts_.subsystem(instance)->get_states(values);
  for (std::size_t k = 0; k < values.size(); ++k)
    coordinates_.push_back(
        {instance, static_cast<int>(k), -1, topology.name(instance) + '.' + info.states[k].name});
  const History& history = run.exchange().history(instance);
  const auto row = history.values(history.newest());
  for (const int index : values_read(instance)) {
    const std::string name = topology.output_name(instance, index % info.output_size());
    const std::string rate(static_cast<std::size_t>(index / info.output_size()), '\'');
    for (int age = 0; age < ages_.back(); ++age) {
      coordinates_.push_back({instance, index, age, fmt::format("{}{} {} samples ago", name, rate, age)});
      values.push_back(row[static_cast<std::size_t>(index)]);
    }
  }
  const auto count = static_cast<Eigen::Index>(values.size());
  start_.conservativeResize(start_.size() + count);
  start_.tail(count) = Eigen::Map<Eigen::VectorXd>(values.data(), count);
}

/// Of the values in its rows.
std::set<int> Trial::values_read(int instance) const {
  const int outputs = parts_.topology().info(instance).output_size();
  std::set<int> all;
  for (const int number : parts_.topology().lines_from(instance)) {
    const Line& line = parts_.topology().lines()[static_cast<std::size_t>(number)];
    for (int k = 0; k <= line.how.derivatives_read(); ++k) all.insert(line.output + k * outputs);
  }
  return all;
}

/// Each subsystem with its part of z.
void Trial::seed(const Eigen::VectorXd& z) {
  std::vector<std::vector<double>> states;
  std::vector<std::vector<std::vector<double>>> past;
  for (int i = 0; i < topology().size(); ++i) {
    const auto width = static_cast<std::size_t>(topology().info(i).row_size() - Samples::header);
    states.emplace_back(topology().info(i).states.size());
    past.emplace_back(static_cast<std::size_t>(ages_[static_cast<std::size_t>(i)]),
                      std::vector<double>(width));
  }
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
  for (const auto& one : seeded_) one->get_states(states.emplace_back(one->info().states.size()));
  Eigen::VectorXd end(z.size());
  for (Eigen::Index k = 0; k < end.size(); ++k) {
    const Coordinate& c = coordinates_[static_cast<std::size_t>(k)];
    const auto i = static_cast<std::size_t>(c.subsystem);
    end[k] = c.age < 0 ? states[i][static_cast<std::size_t>(c.index)] : seeded_[i]->sample(c.age, c.index);
  }
  return end;
}

}  // namespace tandem::stability
