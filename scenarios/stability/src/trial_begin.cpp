// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "starting.hpp"
#include "tandem/identification/identify.hpp"
#include "tandem/identification/surrogate.hpp"
#include "tandem/scenario/shortest_step.hpp"
#include "trial.hpp"

namespace tandem::stability {

void Trial::begin() {
  const Topology& topology = parts_.topology();
  std::vector<Starting> starting;
  for (int i = 0; i < topology.size(); ++i)
    starting.emplace_back(*subsystems_.emplace_back(parts_.subsystem(i)));
  std::vector<Subsystem*> all;
  for (Starting& one : starting) all.push_back(&one);
  Coordinator run(topology, all, coordination_, {scenario_.start, scenario_.stop});
  run.initialize();
  for (int i = 0; i < topology.size(); ++i) {
    const SubsystemInfo& info = topology.info(i);
    own_steps_.push_back(info.abilities.sampled ? info.sampling.period
                                                : scenario::shortest_step(run.own_step(i), scenario_.start));
    inputs_.push_back(starting[static_cast<std::size_t>(i)].inputs());
  }
  find_period();
  std::int64_t before = 1;
  for (int i = 0; i < topology.size(); ++i) {
    if (only_gives(i)) {
      stand_still(i, run);
      continue;
    }
    const double offset = is_sampled(i) ? identify_sampled(i) : 0.0;
    if (!subsystem(i).states()) {
      if (scenario_.subsystems[static_cast<std::size_t>(i)].impulse)
        refuse(i, "has the slow side's own equations in it, and keeps its states to itself");
      identify(i);
    }
    states_.push_back(*subsystem(i).states());
    ages_.push_back(samples_read(i));
    const std::int64_t steps = period_.steps[static_cast<std::size_t>(i)];
    before = std::max(before, (ages_.back() + steps - 1) / steps);
    add_coordinates(i, run);
    const double past = period_.length / static_cast<double>(steps);  // own steps are rounded far from 0
    seeded_.push_back(make_seeded(subsystem(i), scenario_.start, past, offset));
  }
  span_ = {scenario_.start - static_cast<double>(before) * period_.length, scenario_.start + period_.length};
  after(start_);  // so that each knows how many samples it gives up to the start
}

/// What only gives has no part in it: it counts as one that acts at the end.
void Trial::find_period() {
  std::vector<double> lengths;
  for (int i = 0; i < topology().size(); ++i)
    if (!only_gives(i)) lengths.push_back(own_step(i));
  if (coordination_.communication_step && coordination_.schedule == Schedule::Kind::parallel)
    lengths.push_back(*coordination_.communication_step);
  period_ = common_period(lengths, scenario_.start);
  for (int i = 0; i < topology().size(); ++i)
    if (is_sampled(i)) period_.length = period_.last;  // an instant can't be cut
  for (int i = 0; i < topology().size(); ++i)
    if (only_gives(i))
      period_.steps.insert(period_.steps.begin() + i, 1),
          own_steps_[static_cast<std::size_t>(i)] = period_.length;
}

/// A sampled one that reads nobody: what it gives makes others move, and changes nothing in how.
bool Trial::only_gives(int instance) const {
  const auto& lines = topology().lines();
  return is_sampled(instance) && !topology().lines_from(instance).empty() &&
         std::ranges::none_of(lines, [&](const Line& line) { return line.reader == instance; });
}

/// One that keeps its states to itself gets a surrogate, and that its start.
void Trial::identify(int instance) { put(instance, model_of(instance)); }

/// A sampled one always does, as its states are put between instants. From the start to its first instant, or to one that
/// is whole periods earlier [s].
double Trial::identify_sampled(int instance) {
  constexpr double rounding = 1e-9;
  auto model = model_of(instance);
  model.offset = std::fmod(model.offset, model.step);
  if (std::min(model.offset, model.step - model.offset) <= rounding * model.step) model.offset = 0.0;
  models_[instance] = model;
  put(instance, std::move(model));
  return offset(instance);
}

identification::LinearModel Trial::model_of(int instance) {
  constexpr double most = 1e-4;
  const auto at = static_cast<std::size_t>(instance);
  const std::set<int> read = values_read(instance);
  std::int64_t steps = std::clamp<std::int64_t>(2 * period_.steps[at], 12, identification::most_steps);
  const auto told_by = [&] {
    return identification::identify(*parts_.subsystem(instance),
                                    {scenario_.start, inputs_[at], {read.begin(), read.end()}, steps});
  };
  auto model = told_by();
  for (; model.residual > most && steps > 12; model = told_by())
    steps = std::max<std::int64_t>(steps / 2, 12);
  if (model.residual > most)
    refuse(instance, fmt::format("keeps its states to itself, and no linear model tells its outputs: the "
                                 "best leaves {:.2g} of a response; allowed is {}",
                                 model.residual, most));
  return model;
}

/// With what it gives at the start, for all time: its instants are before and after any trial.
void Trial::stand_still(int instance, const Coordinator& run) {
  const double far = 1e6 * period_.length;
  const auto width = static_cast<Eigen::Index>(inputs(instance).size());
  const History& history = run.exchange().history(instance);
  const auto row = history.values(history.newest());
  given_[instance] = {row.begin(), row.end()};
  identification::LinearModel model;
  model.step = period_.length, model.linear = true, model.inputs.setZero(width);
  model.a.resize(0, 0), model.c.resize(0, 0), model.d.resize(0, width), model.s.resize(0, width);
  model.b.resize(0, width * static_cast<Eigen::Index>(identification::places.size()));
  models_[instance] = model;
  const SubsystemInfo& info = topology().info(instance);
  subsystems_[static_cast<std::size_t>(instance)] =
      surrogates_.emplace_back(make_surrogate(std::move(model), info)).get();
  states_.emplace_back(), ages_.push_back(1);
  seeded_.push_back(make_seeded(subsystem(instance), scenario_.start, 2.0 * far, far));
}

void Trial::put(int instance, identification::LinearModel model) {
  const auto at = static_cast<std::size_t>(instance);
  const SubsystemInfo& info = topology().info(instance);
  identified_.push_back({topology().name(instance), is_sampled(instance), static_cast<int>(model.order()),
                         model.residual, model.linear});
  subsystems_[at] = surrogates_.emplace_back(make_surrogate(std::move(model), info)).get();
  std::vector<double> row(static_cast<std::size_t>(info.row_size()));
  Samples unused(row.data(), info.row_size(), 1);
  subsystems_[at]->initialize(scenario_.start, scenario_.stop, inputs_[at], unused);
}

/// Past samples, the newest included, that a reader's segment or mean may be made of. One that lands where sampled ones
/// change has rows between those of its own steps.
int Trial::samples_read(int instance) const {
  int most = 1, landings = 0;
  for (int i = 0; i < topology().size(); ++i) landings += is_sampled(i) && !is_sampled(instance);
  const double latency = topology().info(instance).sampling.latency;
  for (const int number : parts_.topology().lines_from(instance)) {
    const Line& line = parts_.topology().lines()[static_cast<std::size_t>(number)];
    double late =
        line.how.kind == Reconstruction::Kind::mean || line.lag == Lag::memory ? own_step(line.reader) : 0.0;
    if (line.lag == Lag::delay)
      late =
          coordination_.communication_step.value_or(*std::max_element(own_steps_.begin(), own_steps_.end()));
    most = std::max(
        most, line.how.samples() + 1 + static_cast<int>(std::ceil((late + latency) / own_step(instance))));
  }
  return most * (1 + landings);
}

void Trial::add_coordinates(int instance, const Coordinator& run) {
  const Topology& topology = parts_.topology();
  const SubsystemInfo& info = topology.info(instance);
  std::vector<double> values(states(instance).size());
  subsystem(instance).get_states(values);
  for (std::size_t k = 0; k < values.size(); ++k)
    coordinates_.push_back(
        {instance, static_cast<int>(k), -1, topology.name(instance) + '.' + states(instance)[k].name});
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

}  // namespace tandem::stability
