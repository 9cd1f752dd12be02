// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "slow_side.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/scenario/shortest_step.hpp"

namespace tandem::scenario {
namespace {

std::optional<ScalarPort> scalar_port(const std::vector<Port>& ports, const std::string& name) {
  std::size_t index = 0;
  for (const Port& port : ports)
    for (int e = 0; e < port.size; ++e, ++index)
      if (Scalar{&port, e}.name() == name) return ScalarPort{&port, index};
  return {};
}

std::string six_digits(double number) { return fmt::format("{:.6g}", number); }

std::string port_of(const std::string& name) { return name.substr(name.find('.') + 1); }

}  // namespace

Begin begin_of(Subsystem& subsystem, std::span<const double> u0, const Scenario& of) {
  const SubsystemInfo& info = subsystem.info();
  std::vector<double> row(static_cast<std::size_t>(info.row_size()));
  Samples y(row.data(), info.row_size(), 1);
  const Clock clock = subsystem.initialize(of.start, of.stop, u0, y);
  row.erase(row.begin(), row.begin() + Samples::header);
  return {std::move(row), shortest_step(clock.next_time - clock.time, of.start)};
}

SlowSide::SlowSide(const ImpulseEntry& entry, const Scenario& of, const Topology& topology, Subsystem& slow)
    : entry_(entry), of_(of), slow_(slow) {
  for (const ImpulseEntry::Link& link : entry.links) {
    forces_.push_back(found(slow.info().inputs, "input", port_of(link.force)));
    displacements_.push_back(found(slow.info().outputs, "output", port_of(link.displacement)));
    for (const std::string& one : link.effective.accelerance)
      accelerances_.push_back(found(slow.info().outputs, "output", port_of(one)));
  }
  check();
  const int instance = *topology.instance(entry.slow);
  u0_ = topology.start(instance);
  for (std::size_t k = 0; k < u0_.size(); ++k)
    if (const TimeSeries* data = topology.series(instance, static_cast<int>(k)))
      u0_[k] = data->value(of.start);
  for (const ScalarPort& force : forces_) u0_[force.index] = 0.0;
}

bool SlowSide::has_velocities() const {
  return std::any_of(entry_.links.begin(), entry_.links.end(),
                     [](const ImpulseEntry::Link& one) { return one.effective.velocity.has_value(); });
}

std::string SlowSide::velocity_unit(std::size_t link) const {
  const auto& velocity = entry_.links[link].effective.velocity;
  return velocity ? output(port_of(*velocity)).port->unit : "";
}

ScalarPort SlowSide::found(const std::vector<Port>& ports, const char* what, const std::string& name) const {
  const auto one = scalar_port(ports, name);
  if (!one)
    refuse("has no " + std::string(what) + " of one number with the name '" + name +
           "'; allowed is one, or an element of an array");
  return *one;
}

void SlowSide::check() const {
  const Abilities& a = slow_.info().abilities;
  if (a.chooses_step || a.events || a.sampled)
    refuse("has own steps that vary, events or instants; allowed is a fixed own step");
  for (const ScalarPort& one : displacements_)
    if (one.port->derivatives < 2)
      refuse("gives " + std::to_string(one.port->derivatives) + " derivatives of its output " +
             one.port->name + "; allowed are 2, its speed and its acceleration");
}

void SlowSide::refuse(const std::string& why) const {
  throw Error(ErrorCode::not_supported, "impulse coupling: the slow side '" + entry_.slow + "' " + why);
}

void SlowSide::require_reaction(std::size_t link, double acceleration) const {
  const std::string& input = force(link).port->name;
  if (acceleration < 0.0)
    refuse("accelerates by " + six_digits(acceleration) + " for a force of 1 at its input " + input +
           "; allowed is above 0, so that a sign of the input or of the output is to be turned (gain = -1)");
  if (!(acceleration > 0.0))
    refuse("does not accelerate by its input " + input +
           " at once; allowed is one whose acceleration follows the force, or links.effective_mass");
}

void SlowSide::require_longer_step(double own, double fast) const {
  if (!(own > fast))
    refuse("has an own step of " + six_digits(own) + " s, and the fast side one of " + six_digits(fast) +
           " s; allowed is a longer one");
}

Begin SlowSide::pushed(std::size_t link, double force) {
  std::vector<double> u0 = u0_;
  u0[forces_[link].index] = force;
  return begin_of(slow_, u0, of_);
}

double SlowSide::derivative(const Begin& begin, const ScalarPort& of, std::size_t order) const {
  const double value = begin.row[order * static_cast<std::size_t>(slow_.info().output_size()) + of.index];
  if (!std::isfinite(value))
    refuse("starts with a derivative of " + of.port->name +
           " that is not finite, as another input is not known; allowed is a start value of each");
  return value;
}

double SlowSide::small_force() {
  constexpr double part = 1e-4;
  const Begin at = free(), by_1 = pushed(0, 1.0);
  const auto of = [&](const Begin& begin, std::size_t order) {
    return derivative(begin, displacements_[0], order);
  };
  const double h = at.step, a = of(by_1, 2) - of(at, 2);
  const double size = std::max({std::abs(of(at, 0)), h * std::abs(of(at, 1)), h * h * std::abs(of(at, 2))});
  return size > 0.0 && a > 0.0 ? part * size / (0.5 * h * h * a) : 1.0;
}

SlowSide::Moved SlowSide::moved_by(double force, double length) {
  Moved all = after(force, length);
  const Moved without = after(0.0, length);
  for (int k = 0; k < 3; ++k) all.y[k] -= without.y[k], all.v[k] -= without.v[k], all.a[k] -= without.a[k];
  return all;
}

SlowSide::Moved SlowSide::after(double force, double length) {
  if (!slow_.info().abilities.restarts)
    refuse("can't start again; allowed is one that can, or impulse_plain");
  pushed(0, force);
  std::vector<Segment> constants;
  for (const double value : u0_) constants.push_back({of_.stop, of_.start, {value}});
  constants[forces_[0].index].c[0] = force;
  std::vector<Signal> inputs;
  for (const Segment& one : constants) inputs.emplace_back(&one, 1, 0);
  Moved all{};
  for (int k = 0; k < 3; ++k) {
    std::vector<double> row(static_cast<std::size_t>(slow_.info().row_size()));
    Samples y(row.data(), slow_.info().row_size(), 1);
    slow_.advance(of_.start + (k + 1) * length, lands(), inputs, y);
    const double* const at = row.data() + Samples::header + displacements_[0].index;
    const int outputs = slow_.info().output_size();
    all.y[k] = at[0], all.v[k] = at[outputs], all.a[k] = at[2 * outputs];
  }
  return all;
}

}  // namespace tandem::scenario
