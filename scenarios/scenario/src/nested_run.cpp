// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "nested_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "tandem/coordinator/recorder.hpp"
#include "tandem/error.hpp"

namespace tandem::scenario {
namespace {

/// So many times its span it may be run where nobody says how far. Some say a number that is none.
constexpr double longest = 1000.0, longest_said = 1e6;

/// With sources alone that it may be of.
Scenario checked(Scenario scenario, const Builtins& members) {
  std::string allowed;
  for (const auto& [scheme, source] : members.schemes)
    allowed += (allowed.empty() ? "" : ", ") + scheme + ":FILE";
  for (const SubsystemEntry& entry : scenario.subsystems)
    if (!members.schemes.contains(entry.scheme()))
      refuse(entry.source_place,
             fmt::format(
                 "subsystem '{}' is {}, which stands in no scenario that is one subsystem; allowed are {}",
                 entry.name, entry.address(), allowed));
  return scenario;
}

}  // namespace

NestedRun::NestedRun(Scenario scenario, const Builtins& members, double step)
    : scenario_(checked(std::move(scenario), members)), parts_(scenario_, members, Code::run), step_(step) {
  info_.name = scenario_.name;
  for (int i = 0; i < parts_.topology().size(); ++i) note_inputs(i);
  note_outputs();
  for (std::size_t k = 0; k < inputs_.size(); ++k) note_feedthrough(static_cast<int>(k));
  note_abilities();
  if (step_ == 0.0) step_ = slowest_step();
  end_at(scenario_.stop);
  start(scenario_.start, {});  // what can't start is refused here
}

/// Ports that nothing gives. Of an array of which something gives a part the rest is constant.
void NestedRun::note_inputs(int who) {
  const Topology& topology = parts_.topology();
  int first = 0;
  for (const Port& port : topology.info(who).inputs) {
    std::vector<double> starts;
    for (int k = first; k < first + port.size; ++k)
      if (topology.lines_to(who, k).empty() && !topology.series(who, k))
        starts.push_back(topology.start(who)[static_cast<std::size_t>(k)]);
    if (std::ssize(starts) == port.size) {
      for (int k = 0; k < port.size; ++k)
        inputs_.push_back({who, first + k, starts[static_cast<std::size_t>(k)]});
      info_.inputs.push_back({topology.name(who) + "." + port.name, port.unit, port.size, 0, starts.front()});
      if (port.size > 1) info_.inputs.back().starts = std::move(starts);
    }
    first += port.size;
  }
}

void NestedRun::note_outputs() {
  std::vector<std::string> names = scenario_.recording.ports;
  for (int i = 0; i < parts_.topology().size() && scenario_.recording.ports.empty(); ++i)
    for (const Port& port : parts_.topology().info(i).outputs)
      names.push_back(parts_.topology().name(i) + "." + port.name);
  for (const std::string& name : names) note_output(name);
}

void NestedRun::note_output(const std::string& name) {
  const Topology& topology = parts_.topology();
  for (int i = 0; i < topology.size(); ++i) {
    int first = 0;
    for (const Port& port : topology.info(i).outputs) {
      if (topology.name(i) + "." + port.name == name) {
        info_.outputs.push_back(port);
        info_.outputs.back().name = name;
        for (int k = 0; k < port.size; ++k) told_.push_back({i, first + k, port.derivatives});
        return;
      }
      first += port.size;
    }
  }
  refuse_output(name);
}

void NestedRun::refuse_output(const std::string& name) const {
  const auto known = parts_.topology().output_names();
  const bool element = std::find(known.begin(), known.end(), name) != known.end();
  refuse(scenario_.place("record.ports"),
         element ? fmt::format(
                       "record.ports: '{}' is an element of an array; of a scenario that is one subsystem "
                       "allowed are whole ports",
                       name)
                 : unknown_output(known, {name}));
}

/// What an open input reaches at once, from member to member.
void NestedRun::note_feedthrough(int number) {
  const Topology& topology = parts_.topology();
  const OpenInput& from = inputs_[static_cast<std::size_t>(number)];
  std::vector<std::pair<int, int>> inputs{{from.who, from.input}};
  std::set<std::pair<int, int>> outputs;
  const auto pass_on = [&](int who, int output) {
    for (const int k : topology.lines_from(who))
      if (const Line& line = topology.lines()[static_cast<std::size_t>(k)];
          line.output == output && topology.at_once(line))
        inputs.emplace_back(line.reader, line.input);
  };
  while (!inputs.empty()) {
    const auto [who, input] = inputs.back();
    inputs.pop_back();
    if (topology.info(who).abilities.sampled) continue;
    for (const Feedthrough& f : topology.info(who).feedthrough)
      if (f.input == input && outputs.emplace(who, f.output).second) pass_on(who, f.output);
  }
  for (std::size_t k = 0; k < told_.size(); ++k)
    if (outputs.contains({told_[k].who, told_[k].output}))
      info_.feedthrough.push_back({static_cast<int>(k), number});
}

void NestedRun::note_abilities() {
  info_.abilities.serializes_state = true;
  for (int i = 0; i < parts_.topology().size(); ++i) {
    const Abilities& a = parts_.topology().info(i).abilities;
    if (!a.sampled && !a.lands)
      refuse(
          scenario_.subsystems[static_cast<std::size_t>(i)].place,
          fmt::format("subsystem '{}' can't shorten a step; allowed in a scenario that is one subsystem are "
                      "those that can",
                      parts_.topology().name(i)));
    info_.abilities.serializes_state =
        info_.abilities.serializes_state && a.saves_state && a.serializes_state;
  }
}

double NestedRun::slowest_step() const {
  const Coordination& c = scenario_.coordination;
  if (c.schedule == Schedule::Kind::parallel && c.communication_step) return *c.communication_step;
  double slowest = 0.0, sampled = 0.0;
  for (int i = 0; i < parts_.topology().size(); ++i) {
    const SubsystemInfo& info = parts_.topology().info(i);
    double& step = info.abilities.sampled ? sampled : slowest;
    step = std::max(step, info.abilities.sampled ? info.sampling.period : own_step_of(i));
  }
  return slowest > 0.0 ? slowest : sampled;
}

/// As a difference of times, which is the step itself from 0 s on. Data may not be known there.
double NestedRun::own_step_of(int who) const {
  Subsystem& member = *parts_.subsystem(who);
  std::vector<double> row(static_cast<std::size_t>(member.info().row_size()));
  const auto first_step = [&](double t) {
    Samples y(row.data(), member.info().row_size(), 1);
    const Clock clock =
        member.initialize(t, t + scenario_.stop - scenario_.start, parts_.topology().start(who), y);
    return clock.stop == Stop::finished ? 0.0 : clock.next_time - t;
  };
  return text::located(scenario_.subsystems[static_cast<std::size_t>(who)].place, [&] {
    try {
      return first_step(0.0);
    } catch (const Error&) {
      return first_step(scenario_.start);
    }
  });
}

/// [s]: where the run ends; or so far its data are known, or so many times its span.
double NestedRun::horizon(double t) const {
  const double span = scenario_.stop - scenario_.start;
  if (stop_ - t < longest_said * span) return stop_;
  double end = t + longest * span;
  for (int i = 0; i < topology_.size(); ++i)
    for (int k = 0; k < topology_.info(i).input_size(); ++k)
      if (const TimeSeries* data = topology_.series(i, k)) end = std::min(end, data->end());
  return end;
}

/// An input that is not known yet is what it is at the start otherwise.
void NestedRun::start(double t, std::span<const double> u0) {
  topology_ = parts_.topology();
  for (std::size_t k = 0; k < inputs_.size(); ++k)
    topology_.leave_open(inputs_[k].who, inputs_[k].input,
                         u0.empty() || std::isnan(u0[k]) ? inputs_[k].start : u0[k]);
  std::vector<Subsystem*> members;
  for (int i = 0; i < topology_.size(); ++i) members.push_back(parts_.subsystem(i));
  Coordination coordination = scenario_.coordination;
  coordination.pauses = true;
  coordination.diverged_beyond = std::numeric_limits<double>::infinity();  // who runs it watches its outputs
  horizon_ = horizon(t);
  if (run_) run_->forget_states();
  text::located([&](const std::string& sentence) { return scenario_.place_named_in(sentence); },
                [&] {
                  run_.emplace(topology_, members, coordination, TimeSpan{t, horizon_});
                  run_->initialize();
                });
  open_.clear();
  for (const OpenInput& one : inputs_) open_.push_back(&run_->open_input(one.who, one.input));
  go_to(t);
}

void NestedRun::read(double t, std::span<const Signal> u) {
  for (std::size_t k = 0; k < u.size(); ++k) open_[k]->go_on(t, u[k]);
  run_->tell_jumps();
}

/// What jumps there has jumped then.
void NestedRun::go_to(double t) {
  if (TimeTolerance(t).before(horizon_, t))
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("scenario '{}' is run to t = {} s; allowed is up to {} s, where data of it end, or {} "
                    "times its span",
                    scenario_.name, t, horizon_, longest));
  run_->run_to(t);
  run_->tell_jumps();
}

/// Where it stands. (A sampled one with a latency may have told what holds later.)
const double* NestedRun::row(int who) const {
  const History& history = run_->exchange().history(who);
  const double here = run_->schedule().stop();
  std::int64_t row = history.newest();
  while (row > history.oldest() && TimeTolerance(here).before(here, history.time(row))) --row;
  return history.row(row);
}

void NestedRun::outputs(double* y) const {
  const std::size_t count = told_.size();
  const int blocks = info_.derivatives();
  for (std::size_t k = 0; k < count; ++k) {
    const auto [who, output, derivatives] = told_[k];
    const double* values = row(who) + Samples::header + output;
    const int stride = topology_.info(who).output_size();
    for (int order = 0; order <= blocks; ++order)
      y[static_cast<std::size_t>(order) * count + k] = order <= derivatives ? values[order * stride] : 0.0;
  }
}

std::vector<std::string> NestedRun::notes() const {
  std::vector<std::string> all = run_->notes(), of_parts = parts_.notes();
  all.insert(all.end(), of_parts.begin(), of_parts.end());
  return all;
}

NestedModel& NestedModel::operator=(const NestedModel& other) {
  if (this == &other) return *this;
  if (is_run_)
    restore(other.bytes());
  else
    bytes_ = other.bytes();
  return *this;
}

std::vector<std::byte> NestedModel::bytes() const {
  if (!is_run_) return bytes_;
  ByteWriter to;
  run_->write(to);
  return {to.bytes().begin(), to.bytes().end()};
}

void NestedModel::restore(std::span<const std::byte> bytes) const {
  ByteReader from(bytes, run_->info().name, "state of");
  run_->read(from);
  from.end();
}

void NestedModel::write(ByteWriter& to) const {
  const auto all = bytes();
  to.put(std::uint64_t{all.size()});
  to.put_bytes(all);
}

/// Into a copy. The run tells whether they are a state, and stands where it stood then.
void NestedModel::read(ByteReader& from) {
  const auto taken = from.take_bytes(from.take<std::uint64_t>());
  ByteWriter now;
  run_->write(now);
  try {
    restore(taken);
  } catch (...) {
    restore(now.bytes());
    throw;
  }
  restore(now.bytes());
  bytes_.assign(taken.begin(), taken.end());
}

}  // namespace tandem::scenario
