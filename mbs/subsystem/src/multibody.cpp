// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "multibody.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "own_step.hpp"
#include "slow_mechanism.hpp"
#include "tandem/mbs/mechanism/freedom.hpp"
#include "tandem/mbs/mechanism/initial.hpp"

namespace tandem::mbs {

Multibody::Machine::Machine(Description description, const SubsystemSettings& settings)
    : mechanism(std::move(description)),
      stepper(make_stepper(mechanism, for_own_steps(settings))),
      outputs(mechanism),
      inputs(mechanism.description()),
      dump(settings.dump),
      limits(mechanism, settings.tell) {
  for (int k = 0; k < outputs.size(); ++k) {
    derivatives = std::max(derivatives, outputs.derivatives(k));
    for (const int input : inputs.ports()) feeds_through = feeds_through || outputs.depends(k, input);
  }
  mechanism.set_inputs(&inputs);
  note_jumps();
}

void Multibody::Machine::note_jumps() {
  const auto& all = mechanism.description().inputs;
  for (std::size_t i = 0; i < all.size(); ++i) {
    jumps.insert(jumps.end(), all[i].jumps.begin(), all[i].jumps.end());
    for (int k = 0; k < outputs.size(); ++k)
      outputs_jump = outputs_jump || (!all[i].jumps.empty() && outputs.depends(k, static_cast<int>(i)));
  }
  std::sort(jumps.begin(), jumps.end());
  before.resize(static_cast<std::size_t>(outputs.size()) * static_cast<std::size_t>(1 + derivatives));
}

Multibody::Multibody(Description description, const SubsystemSettings& settings)
    : machine_(std::make_shared<Machine>(std::move(description), settings)),
      step_(settings.step),
      moving_(machine_->stepper),
      inputs_(machine_->inputs.ports().size()) {
  check_step("mechanism '" + machine_->mechanism.description().name + "'", step_);
}

SubsystemInfo Multibody::info() const {
  const Mechanism& m = machine_->mechanism;
  const Outputs& outputs = machine_->outputs;
  SubsystemInfo info;
  info.name = m.description().name;
  info.abilities.serializes_state = true;
  info.abilities.events = machine_->outputs_jump;
  for (const int input : machine_->inputs.ports()) {
    const Input& i = m.description().inputs[static_cast<std::size_t>(input)];
    info.inputs.push_back({i.name, i.unit, 1, 0, i.value});
  }
  for (int k = 0; k < outputs.size(); ++k) {
    info.outputs.push_back({outputs.name(k), outputs.unit(k), 1, outputs.derivatives(k)});
    for (int port = 0; port < static_cast<int>(info.inputs.size()); ++port)
      if (outputs.depends(k, machine_->inputs.ports()[static_cast<std::size_t>(port)]))
        info.feedthrough.push_back({k, port});
  }
  return info;
}

/// What is not known yet counts as zero, and what follows it at once is not told.
void Multibody::start(double t, std::span<const double> u0) {
  std::vector<double> values(u0.begin(), u0.end());
  unknown_.clear();
  for (std::size_t port = 0; port < values.size(); ++port)
    if (std::isnan(values[port])) {
      values[port] = 0.0;
      unknown_.push_back(machine_->inputs.ports()[port]);
    }
  machine_->inputs.set_constants(values);
  moving_.start(initial_state(machine_->mechanism, t));
  machine_->outputs.start(moving_.state());
  machine_->limits.start(moving_.state());
  machine_->begun = false;
  machine_->inputs.read(t, inputs_);
  machine_->dumped = 0;
  dump_matrices();
}

/// Where they are other than at the end of the step before, accelerations and multipliers follow.
bool Multibody::take_inputs(double t, std::span<const Signal> u) {
  unknown_.clear();
  machine_->inputs.set(u);
  if (!machine_->inputs.read(t, inputs_)) return false;
  moving_.refresh(t);
  return true;
}

bool Multibody::jump(double t, std::span<const Signal> u) {
  return machine_->feeds_through && take_inputs(t, u);
}

/// Just before a jump a part of the step ends, and accelerations follow the jump.
void Multibody::pass_jump(double t, const OwnStep& part) {
  moving_.step(part.length, std::nextafter(t, -std::numeric_limits<double>::infinity()));
  if (machine_->outputs_jump) outputs(machine_->before.data());
  moving_.refresh(t);
}

/// In parts, where inputs jump that are functions of time. True: outputs have with them, at s.end.
bool Multibody::move(OwnStep& s) {
  const TimeTolerance tolerance;
  const auto& jumps = machine_->jumps;
  const auto is_passed = [&](double t) { return !tolerance.before(s.begin, t); };
  auto at = std::find_if_not(std::lower_bound(jumps.begin(), jumps.end(), s.begin), jumps.end(), is_passed);
  for (; at != jumps.end() && !tolerance.before(s.end, *at); ++at) {
    pass_jump(*at, {s.begin, *at, *at - s.begin});
    if (machine_->outputs_jump) return s.end = *at, true;
    s = {*at, s.end, s.end - *at};
  }
  if (tolerance.before(s.begin, s.end)) moving_.step(s.length, s.end);
  return false;
}

void Multibody::outputs_before(double* y) const {
  std::copy(machine_->before.begin(), machine_->before.end(), y);
}

bool Multibody::step_to_event(OwnStep& s, std::span<const Signal> u) {
  take_inputs(s.begin, u);
  if (!std::exchange(machine_->begun, true)) machine_->limits.look(moving_.state());
  const bool jumps = move(s);
  machine_->inputs.read(s.end, inputs_);
  machine_->limits.look(moving_.state());
  dump_matrices();
  return jumps;
}

/// Where the state has got to the next of the times.
void Multibody::dump_matrices() const {
  Machine& m = *machine_;
  const auto due = [&] {
    return m.dumped < m.dump.times.size() && moving_.state().time >= m.dump.times[m.dumped];
  };
  if (m.dump.folder.empty() || !due()) return;
  while (due()) ++m.dumped;
  mbs::write(step_matrices(m.mechanism, moving_.state(), m.stepper->tangent_factors(step_)), m.dump.folder,
             fmt::format("{}", moving_.state().time), m.dump.format);
}

void Multibody::outputs(double* y) const {
  Outputs& outputs = machine_->outputs;
  outputs.evaluate(moving_.state(), y);
  for (int order = 1; order <= machine_->derivatives; ++order)
    outputs.derivatives(moving_.state(), order, y + std::ptrdiff_t{order} * outputs.size());
  if (!unknown_.empty()) hide_unknown(y);
}

void Multibody::hide_unknown(double* y) const {
  const Outputs& outputs = machine_->outputs;
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  for (int k = 0; k < outputs.size(); ++k) {
    for (const int input : unknown_)
      if (outputs.depends(k, input)) y[k] = nothing;
    const int order = outputs.derivatives(k);  // the last derivative is an acceleration
    if (order > 0) y[order * outputs.size() + k] = nothing;
  }
}

/// Redundant equations, and data that end before: these refuse a time beyond them, where other functions have
/// a value.
std::vector<std::string> Multibody::remarks(double t_stop) const {
  const Description& d = machine_->mechanism.description();
  if (moving_.state().q.size() == 0)
    throw Error(ErrorCode::wrong_state, "mechanism '" + d.name +
                                            "' is asked for remarks before initialize(), where it stands "
                                            "nowhere yet; allowed is after it");
  std::vector<std::string> all;
  if (const auto names = redundant_equations(); !names.empty())
    all.push_back(fmt::format("{} redundant equation{}: {}", names.size(), names.size() > 1 ? "s" : "",
                              fmt::join(names, ", ")));
  for (const Input& input : d.inputs)
    if (input.function) try {
        input.function(t_stop);
      } catch (const Error& error) {
        all.push_back(fmt::format("input '{}': {}; the run to {} s fails where they end", input.name,
                                  error.what(), t_stop));
      }
  return all;
}

/// No gradient depends on inputs; signals of the last call are gone.
std::vector<std::string> Multibody::redundant_equations() const {
  Mechanism& m = machine_->mechanism;
  m.set_inputs(nullptr);
  const Freedom found = freedom(m, moving_.state());
  m.set_inputs(&machine_->inputs);
  std::vector<std::string> names;
  for (const int c : found.redundant)
    names.push_back(m.structure().constraint_names[static_cast<std::size_t>(c)]);
  return names;
}

/// The same from one start to the next: signals of the last call are gone, and no gradient depends on inputs.
const Independent& Multibody::independent() const {
  Machine& m = *machine_;
  if (!m.independent) {
    m.mechanism.set_inputs(nullptr);
    m.independent.emplace(m.mechanism, moving_.state());
    m.mechanism.set_inputs(&m.inputs);
  }
  return *m.independent;
}

std::shared_ptr<SlowModel> Multibody::slow_model(std::span<const SlowLink> links) const {
  const std::vector<int>& ports = machine_->inputs.ports();
  const auto where = [this, &ports](Eigen::VectorXd& q, std::vector<InputValue>& inputs) {
    q = moving_.state().q;
    for (std::size_t port = 0; port < ports.size(); ++port)
      inputs[static_cast<std::size_t>(ports[port])] = inputs_[port];
  };
  return slow_model_of(machine_->mechanism.description(), where, ports, links);
}

std::optional<std::vector<StateName>> Multibody::states() const {
  std::vector<StateName> all;
  for (const std::string& name : independent().names()) all.push_back({name, ""});
  return all;
}

void Multibody::get_states(std::span<double> x) const { independent().get(moving_.state(), x); }

void Multibody::set_states(std::span<const double> x) {
  moving_.start(independent().put(moving_.state(), x));
  machine_->outputs.start(moving_.state());
  machine_->limits.start(moving_.state());
}

void Multibody::write(ByteWriter& to) const {
  moving_.write(to);
  for (const InputValue& input : inputs_)
    to.put_doubles(std::array{input.value, input.rate, input.acceleration});
  to.put(std::uint8_t{unknown_.empty()});
}

void Multibody::read(ByteReader& from) {
  moving_.read(from);
  for (InputValue& input : inputs_) input = {from.take<double>(), from.take<double>(), from.take<double>()};
  if (from.take<std::uint8_t>() != 0) unknown_.clear();
}

std::unique_ptr<Subsystem> make_subsystem(Description description, const SubsystemSettings& settings) {
  return std::make_unique<FixedStep<Multibody>>(Multibody(std::move(description), settings));
}

}  // namespace tandem::mbs
