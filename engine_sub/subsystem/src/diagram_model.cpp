// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "diagram_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tandem/engine/compile.hpp"
#include "tandem/error.hpp"

namespace tandem::engine {

void SignalInputs::at(double t, double* values) {
  if (signals_.empty())
    std::copy(constants_.begin(), constants_.end(), values);
  else
    for (const Signal& signal : courses_.empty() ? signals_ : courses_) *values++ = signal.value(t, z_);
}

bool SignalInputs::jump_at(double t) {
  return std::any_of(signals_.begin(), signals_.end(),
                     [t](const Signal& signal) { return signal.jumps_at(t, TimeTolerance()); });
}

/// The segment of each signal after t.
double SignalInputs::begin_course(double t) {
  double end = std::numeric_limits<double>::infinity();
  courses_.clear();
  const double now = t + 8.0 * std::numeric_limits<double>::epsilon() * std::abs(t);
  for (const Signal& signal : signals_) {
    const auto segments = signal.segments();
    std::size_t k = 0;
    while (k + 1 < segments.size() && segments[k].end <= now) ++k;
    courses_.push_back(Signal(&segments[k], 1, signal.degree()).with(signal.reactive()));
    if (k + 1 < segments.size()) end = std::min(end, segments[k].end);
  }
  return end;
}

DiagramModel::Machine::Machine(const Description& of, const SubsystemSettings& settings)
    : diagram{of.name, of.parameters, of.inputs, {}, of.outputs},
      program(compile(of)),
      simulation(program, &inputs, make_integrator(settings.integrator), settings.simulation) {}

DiagramModel::DiagramModel(const Description& diagram, const SubsystemSettings& settings)
    : machine_(std::make_shared<Machine>(diagram, settings)),
      step_(settings.step),
      hidden_(diagram.outputs.size()) {
  check_step(diagram.name);
  if (diagram.outputs.empty())
    throw Error(
        ErrorCode::invalid_argument,
        "diagram '" + diagram.name + "' has no output, so nothing in it is of use; allowed is one or more");
  if (settings.simulation.tell)
    for (const std::string& block : machine_->program.left_out)
      settings.simulation.tell("block '" + block + "' feeds no output and is left out");
}

void DiagramModel::check_step(const std::string& name) const {
  const auto refuse = [&](const std::string& what) {
    throw Error(ErrorCode::invalid_argument, "diagram '" + name + "' " + what);
  };
  if (const double period = program().shortest_period; program().sampled() && step_ != 0.0)
    refuse(
        fmt::format("is sampled: all it gives changes at its blocks' instants alone, {} s or more apart; it "
                    "takes no own steps, and allowed is no step in place of {} s",
                    period, step_));
  if (!program().sampled() && (!(step_ > 0.0) || !std::isfinite(step_)))
    refuse(fmt::format(
        "has no own step: step is {} s; allowed is a finite number above 0, by the parameter step or "
        "step in the table [run] of its file",
        step_));
}

DiagramModel::DiagramModel(const DiagramModel& other) { *this = other; }

DiagramModel& DiagramModel::operator=(const DiagramModel& other) {
  if (this == &other) return *this;
  const bool is_kept = !other.kept_.empty();
  kept_ = is_kept ? other.kept_ : other.machine_->simulation.keep();
  kept_time_ = is_kept ? other.kept_time_ : other.machine_->simulation.time();
  machine_ = other.machine_;
  step_ = other.step_;
  hidden_ = other.hidden_;
  return *this;
}

SubsystemInfo DiagramModel::info() const {
  const Machine& m = *machine_;
  SubsystemInfo info;
  info.name = m.diagram.name;
  info.abilities.serializes_state = m.simulation.keeps_exactly();
  info.abilities.reactive_inputs = !m.program.sampled() && m.simulation.takes_reaction();
  info.abilities.events = !m.program.sampled() && m.program.jumps();
  for (const Input& input : m.diagram.inputs) info.inputs.push_back({input.name, input.unit});
  for (std::size_t k = 0; k < m.diagram.outputs.size(); ++k) {
    info.outputs.push_back({m.diagram.outputs[k].name, m.diagram.outputs[k].unit});
    info.outputs.back().derivatives = m.program.outputs[k] < m.program.states ? 1 : 0;
    info.outputs.back().held = m.program.courses[k].held;
  }
  for (const auto& [output, input] : m.program.feedthrough) info.feedthrough.push_back({output, input});
  return info;
}

std::optional<std::vector<StateName>> DiagramModel::states() const {
  const Program& p = program();
  const bool remembers = !p.crossings.empty() || !p.periodics.empty() || !p.delays.empty() ||
                         !p.calls.empty() || !p.step_updates.empty() || !p.settled.empty();
  if (remembers || !machine_->simulation.keeps_exactly()) return {};
  std::vector<StateName> names;
  for (const std::string& name : p.state_names) names.push_back({name, ""});
  return names;
}

void DiagramModel::get_states(std::span<double> x) const {
  std::copy_n(image().begin(), x.size(), x.begin());
}

void DiagramModel::set_states(std::span<const double> x) { resume().put_states(x); }

/// What is not known yet counts as zero, and what follows it at once is not told.
void DiagramModel::start(double t, std::span<const double> u0) {
  Machine& m = *machine_;
  std::vector<double> values(u0.begin(), u0.end());
  std::fill(hidden_.begin(), hidden_.end(), false);
  if (!m.program.sampled())
    for (const auto& [output, input] : m.program.feedthrough)
      if (std::isnan(u0[static_cast<std::size_t>(input)])) hidden_[static_cast<std::size_t>(output)] = true;
  for (double& value : values)
    if (std::isnan(value)) value = 0.0;
  m.inputs.set_constants(values);
  m.simulation.start(t, !m.program.sampled());
  kept_.clear();
}

Simulation& DiagramModel::resume() {
  Simulation& simulation = machine_->simulation;
  if (!kept_.empty()) simulation.restore(kept_time_, kept_), kept_.clear();
  return simulation;
}

void DiagramModel::react(const Reaction* reaction) {
  if (reaction || !reaction_states().empty()) resume().react(reaction);
}

void DiagramModel::set_inputs(std::span<const Signal> u) {
  machine_->inputs.set(u, reaction_states().data());
  std::fill(hidden_.begin(), hidden_.end(), false);
}

/// An event is located to some 1e-12 of a step: nearer to an end of the step it is there, so that rounding of times does
/// not decide whether it is. Of several at its begin the first is: else one that switches to and fro would not move.
bool DiagramModel::step_to_event(OwnStep& s, std::span<const Signal> u) {
  set_inputs(u);
  Simulation& simulation = resume();
  const bool first = simulation.time() <= s.begin;
  if (!simulation.run_to_jump(s.end)) return false;
  const double t = simulation.time(), close = 4e-12 * s.length;
  if (s.end - t > close) s.end = first && t - s.begin <= close ? s.begin : t;
  return true;
}

void DiagramModel::outputs_before(double* y) const {
  std::copy(machine_->simulation.left().begin(), machine_->simulation.left().end(), y);
}

bool DiagramModel::jump(double, std::span<const Signal> u) {
  if (program().feedthrough.empty()) return false;
  set_inputs(u);
  return resume().jump();
}

void DiagramModel::act(double t, std::span<const double> u) {
  machine_->inputs.set_constants(u);
  resume().act(t);
}

void DiagramModel::look(double t, std::span<const double> u, double* y) {
  Simulation& simulation = resume();
  const double now = simulation.time();
  machine_->before = simulation.signals();
  act(t, u);
  outputs(y);
  simulation.restore(now, machine_->before);
}

void DiagramModel::outputs(double* y) const {
  program().row(image().data(), y);
  for (std::size_t k = 0; k < hidden_.size(); ++k)
    if (hidden_[k]) y[k] = std::numeric_limits<double>::quiet_NaN();
}

/// Data that end before.
std::vector<Figure> DiagramModel::figures() const {
  const Statistics s = machine_->simulation.statistics();
  return {{"steps", s.steps},
          {"rate_evaluations", s.rate_evaluations},
          {"root_evaluations", s.root_evaluations},
          {"failed_error_tests", s.failed_error_tests},
          {"nonlinear_iterations", s.nonlinear_iterations},
          {"failed_iterations", s.failed_iterations},
          {"jacobians", s.jacobians},
          {"restarts", s.restarts}};
}

std::vector<std::string> DiagramModel::remarks(double t_stop) const {
  std::vector<std::string> all;
  for (const Range& r : program().ranges)
    if (r.signal == program().time && TimeTolerance().before(r.high, t_stop))
      all.push_back(fmt::format("{}: the data end at t = {} s; the run to {} s fails where they end", r.owner,
                                r.high, t_stop));
  return all;
}

/// Of a state that is kept, as all are that leave the process.
void DiagramModel::write(ByteWriter& to) const {
  to.put(kept_time_);
  to.put_list(kept_);
  to.put(std::uint8_t{std::none_of(hidden_.begin(), hidden_.end(), [](bool hidden) { return hidden; })});
}

void DiagramModel::read(ByteReader& from) {
  kept_time_ = from.take<double>();
  from.take_list(kept_);
  if (from.take<std::uint8_t>() != 0) std::fill(hidden_.begin(), hidden_.end(), false);
}

}  // namespace tandem::engine
