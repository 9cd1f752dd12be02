// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/exported/exchanged_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/sources/diagram.hpp"
#include "tandem/transports/source_uri.hpp"

namespace tandem::exported {
namespace {

using Kind = Variable::Kind;

void check_size(const char* what, std::size_t found, std::size_t allowed) {
  if (found != allowed)
    throw Error(ErrorCode::invalid_argument, fmt::format("{} {}; allowed is {}", found, what, allowed));
}

/// Of outputs the first that shows a state stands for it.
ExchangedStates states_of(const engine::Program& program) {
  ExchangedStates all{program.state_names, {}, {}, static_cast<int>(program.crossings.size())};
  for (const int slot : program.outputs) {
    const auto& before = all.of_outputs;
    const bool is_first = std::find(before.begin(), before.end(), slot) == before.end();
    all.of_outputs.push_back(slot < program.states && is_first ? slot : -1);
  }
  all.reset.resize(program.state_names.size());
  const auto note = [&](const auto& events) {
    for (const auto& event : events)
      for (const engine::Update& u : event.updates)
        if (u.to < program.states) all.reset[static_cast<std::size_t>(u.to)] = 1;
  };
  note(program.crossings), note(program.periodics);
  return all;
}

}  // namespace

ExchangedUnit::ExchangedUnit(const std::filesystem::path& resources, const Tell& tell)
    : Unit(resources, tell), tell_(tell) {
  open_source();
  variables_ = exported::variables(info_, start_values(), file_parameters(), &*states_);
}

void ExchangedUnit::open_source() {
  const SourceUri source(manifest_.source);
  if (source.scheme != "diagram")
    throw Error(ErrorCode::not_supported,
                "'" + info_.name + "' is no diagram; of any other source allowed is Co-Simulation");
  Parameters parameters = given();
  auto diagram = exchanged_diagram({resources_ / source.place, {}, manifest_.overrides}, parameters, tell_);
  parameters.refuse_unused(manifest_.source);
  const ExchangedStates now = states_of(diagram->program());
  if (!states_) states_ = now;
  if (!states_->covers(now))
    throw Error(ErrorCode::invalid_argument,
                "'" + info_.name +
                    "' has other states or more events with these parameters than with those that it was "
                    "exported with; allowed is another export");
  watched_ = now.indicators, diagram_ = std::move(diagram);
  rates_.resize(states_size());
}

double ExchangedUnit::own_step() {
  start();
  return diagram_->own_step();
}

void ExchangedUnit::set_inputs(const Inputs& inputs) {
  const auto& values = inputs.values();
  for (std::size_t k = 0; k < values.size(); ++k) diagram_->set_input(static_cast<int>(k), values[k]);
}

void ExchangedUnit::start_source() {
  set_inputs(inputs_);
  diagram_->start(start_);
}

void ExchangedUnit::input_set(const Variable& v) { diagram_->set_input(v.index, inputs_.value(v.index)); }

double ExchangedUnit::output(const Variable& v) {
  switch (v.kind) {
    case Kind::output:
      return diagram_->output(v.index);
    case Kind::state:
      return diagram_->states()[static_cast<std::size_t>(v.index)];
    case Kind::rate:
      diagram_->rates(rates_.data());
      return rates_[static_cast<std::size_t>(v.index)];
    default:
      return indicator(v.index);
  }
}

void ExchangedUnit::set_time(double t) {
  if (!std::isfinite(t))
    throw Error(ErrorCode::invalid_argument, fmt::format("time is {} s; allowed is a finite number", t));
  check_begun();
  diagram_->go_to(time_ = t);
}

void ExchangedUnit::set_states(std::span<const double> x) {
  check_begun();
  check_size("states are set", x.size(), states_size());
  diagram_->set_states(x);
}

void ExchangedUnit::get_states(std::span<double> x) {
  start();
  check_size("states are wanted", x.size(), states_size());
  std::copy_n(diagram_->states().begin(), x.size(), x.begin());
}

void ExchangedUnit::get_rates(std::span<double> dx) {
  start();
  check_size("derivatives of states are wanted", dx.size(), states_size());
  diagram_->rates(dx.data());
}

void ExchangedUnit::get_indicators(std::span<double> z) {
  start();
  check_size("event indicators are wanted", z.size(), indicators_size());
  for (std::size_t k = 0; k < z.size(); ++k) z[k] = indicator(static_cast<int>(k));
}

/// 1 for an event that it lacks with these parameters.
double ExchangedUnit::indicator(int number) const {
  return number < watched_ ? diagram_->watched(number) : 1.0;
}

void ExchangedUnit::get_nominals(std::span<double> x) const {
  check_size("nominal values of states are wanted", x.size(), states_size());
  std::fill(x.begin(), x.end(), 1.0);
}

void ExchangedUnit::step_done() {
  check_begun();
  diagram_->arrive();
}

double ExchangedUnit::event() {
  check_begun();
  diagram_->act();
  return diagram_->next_event();
}

void ExchangedUnit::write_started(ByteWriter& to) {
  to.put_list(diagram_->state());
  to.put_list(diagram_->guesses());
  to.put(static_cast<std::uint8_t>(diagram_->known()));
}

void ExchangedUnit::read_started(ByteReader& from, double time, const Inputs& inputs) {
  std::vector<double> image(diagram_->state().size());
  from.take_list(image);
  std::vector<double> guesses(diagram_->guesses().size());
  from.take_list(guesses);
  const auto known = static_cast<engine::ExchangedDiagram::Known>(from.take<std::uint8_t>());
  if (known > engine::ExchangedDiagram::Known::all) from.refuse("what is known of its signals is no word");
  from.end();
  set_inputs(inputs);
  diagram_->restore(time, image, guesses, known);
}

}  // namespace tandem::exported
