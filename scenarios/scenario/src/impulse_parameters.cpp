// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <functional>

#include "impulse.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::scenario {
namespace {

/// How a subsystem starts.
struct Begin {
  std::vector<double> row;  ///< outputs, then derivatives
  double step;              ///< its first own step [s]
};

Begin begin_of(Subsystem& subsystem, std::span<const double> u0, const Scenario& of) {
  const SubsystemInfo& info = subsystem.info();
  std::vector<double> row(static_cast<std::size_t>(info.row_size()));
  Samples y(row.data(), info.row_size(), 1);
  const Clock clock = subsystem.initialize(of.start, of.stop, u0, y);
  row.erase(row.begin(), row.begin() + Samples::header);
  return {std::move(row), clock.next_time - clock.time};
}

/// A scalar of a port that is named whole, "slow.x2", or with its element.
struct ScalarPort {
  const Port* port;
  std::size_t index;  ///< flattened
};
std::optional<ScalarPort> scalar_port(const std::vector<Port>& ports, const std::string& name) {
  std::size_t index = 0;
  for (const Port& port : ports)
    for (int e = 0; e < port.size; ++e, ++index)
      if (Scalar{&port, e}.name() == name) return ScalarPort{&port, index};
  return {};
}

std::string port_of(const std::string& name) { return name.substr(name.find('.') + 1); }

class Asked {
 public:
  Asked(const ImpulseEntry& entry, const Scenario& of, const Topology& topology,
        std::function<Subsystem&(int)> subsystem)
      : entry_(entry),
        of_(of),
        topology_(topology),
        subsystem_(subsystem),
        slow_(subsystem(*topology.instance(entry.slow))) {
    for (const ImpulseEntry::Link& link : entry.links) {
      forces_.push_back(found(slow_.info().inputs, "input", link.force));
      displacements_.push_back(found(slow_.info().outputs, "output", link.displacement));
      for (const std::string& one : link.effective.accelerance)
        accelerances_.push_back(found(slow_.info().outputs, "output", one));
    }
  }

  std::vector<Parameter> parameters() {
    check_slow();
    std::vector<double> u0 = topology_.start(*topology_.instance(entry_.slow));
    for (std::size_t k = 0; k < u0.size(); ++k)
      if (const TimeSeries* data = topology_.series(*topology_.instance(entry_.slow), static_cast<int>(k)))
        u0[k] = data->value(of_.start);
    for (const ScalarPort& force : forces_) u0[force.index] = 0.0;
    const Begin free = begin_of(slow_, u0, of_);
    const double fast = fast_step();
    if (!(free.step > fast))
      refuse("has an own step of " + std::to_string(free.step) + " s, and the fast side one of " +
             std::to_string(fast) + " s; allowed is a longer one");
    set("own_step", fast), set("slow_step", free.step), set("fast_period", of_.fast_period);
    for (std::size_t k = 0; k < forces_.size(); ++k) {
      set(at("force_unit", k), forces_[k].port->unit),
          set(at("displacement_unit", k), displacements_[k].port->unit);
      set(at("velocity", k), derivative(free, k, 1)), set(at("free_acceleration", k), derivative(free, k, 2));
    }
    if (entry_.with_stiffness) set_springs(u0, free);
    for (std::size_t i = 0; i < accelerances_.size(); ++i) tell_accelerance(i, free);
    for (std::size_t k = 0; k < forces_.size(); ++k) {
      u0[forces_[k].index] = 1.0;
      const Begin pushed = begin_of(slow_, u0, of_);
      u0[forces_[k].index] = 0.0;
      const auto found = [&](std::size_t i) { return derivative(pushed, i, 2) - derivative(free, i, 2); };
      for (std::size_t i = 0; i < forces_.size(); ++i) {
        if (!accelerances_.empty()) check_told(i * forces_.size() + k, found(i), found(k), free);
        set_accelerance(i, k, found(i));
      }
    }
    return std::move(all_);
  }

 private:
  void set(std::string name, Parameters::Value value) {
    all_.push_back({std::move(name), std::move(value), {}});
  }
  static std::string at(const char* name, std::size_t k) {
    return std::string(name) + "." + std::to_string(k + 1);
  }

  ScalarPort found(const std::vector<Port>& ports, const char* what, const std::string& name) const {
    const auto one = scalar_port(ports, port_of(name));
    if (!one)
      refuse("has no " + std::string(what) + " of one number with the name '" + port_of(name) +
             "'; allowed is one, or an element of an array");
    return *one;
  }

  void check_slow() const {
    const Abilities& a = slow_.info().abilities;
    if (a.chooses_step || a.events || a.sampled)
      refuse("has own steps that vary, events or instants; allowed is a fixed own step");
    for (std::size_t k = 0; k < displacements_.size(); ++k)
      if (displacements_[k].port->derivatives < 2)
        refuse("gives " + std::to_string(displacements_[k].port->derivatives) +
               " derivatives of its output " + displacements_[k].port->name +
               "; allowed are 2, its speed and its acceleration");
  }
  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(ErrorCode::not_supported, "impulse coupling: the slow side '" + entry_.slow + "' " + why);
  }

  /// The shortest of the fast sides.
  double fast_step() {
    double shortest = of_.stop - of_.start;
    for (const ImpulseEntry::Link& link : entry_.links) {
      const int fast = *topology_.instance(link.fast);
      shortest = std::min(shortest, begin_of(subsystem_(fast), topology_.start(fast), of_).step);
    }
    return shortest;
  }

  double derivative(const Begin& begin, std::size_t link, std::size_t order) const {
    return derivative(begin, displacements_[link], order);
  }
  double derivative(const Begin& begin, const ScalarPort& of, std::size_t order) const {
    const double value = begin.row[order * static_cast<std::size_t>(slow_.info().output_size()) + of.index];
    if (!std::isfinite(value))
      refuse("starts with a derivative of " + of.port->name +
             " that is not finite, as another input is not known; allowed is a start value of each");
    return value;
  }

  void tell_accelerance(std::size_t e, const Begin& free) {
    const ScalarPort& of = accelerances_[e];
    if (of.port->derivatives < 1)
      refuse("gives no derivative of its output " + of.port->name +
             "; allowed in links.accelerance is one with it");
    set(at("accelerance_rate", e), derivative(free, of, 1)), set(at("accelerance_unit", e), of.port->unit);
  }

  /// What the output tells is what a force has been found to do here; own: at its own displacement.
  void check_told(std::size_t e, double found, double own, const Begin& free) const {
    const double told = derivative(free, accelerances_[e], 0), off = std::abs(told - found);
    if (!(off <= 1e-6 * std::max({std::abs(told), std::abs(found), std::abs(own)})))
      refuse("starts with " + accelerances_[e].port->name + " = " + std::to_string(told) +
             ", and accelerates by " + std::to_string(found) +
             " for a force of 1; allowed in links.accelerance is the same to 1e-6");
  }

  void set_springs(std::vector<double> u0, const Begin& free) {
    const Effective& stated = entry_.links[0].effective;
    set("stiffness.1", *stated.stiffness), set("damping.1", stated.damping.value_or(0.0));
    set("degree", 4.0);
    const double without = after_a_step(u0);
    u0[forces_[0].index] = 1.0;
    const double pushed = after_a_step(u0),
                 a = derivative(begin_of(slow_, u0, of_), 0, 2) - derivative(free, 0, 2);
    set("trapezoidal",
        takes_ends(pushed - without, a, *stated.stiffness * a * free.step * free.step, free.step));
  }

  /// A constant force moves a spring's end by h^2 a / 2 (1 - c k h^2) in a step, k = stiffness / mass: the trapezoidal
  /// rule, which takes the positions at both ends, has c = 1/4, an exact integrator 1/12.
  static bool takes_ends(double moved, double a, double k_h2, double h) {
    return (1.0 - moved / (0.5 * h * h * a)) / k_h2 > 1.0 / 6.0;
  }

  /// Where the displacement is after one step with these inputs.
  double after_a_step(const std::vector<double>& u0) {
    if (!slow_.info().abilities.restarts)
      refuse("can't start again; allowed is one that can, or impulse_plain");
    const Begin begin = begin_of(slow_, u0, of_);
    const double end = of_.start + begin.step;
    std::vector<Segment> constants;
    for (const double value : u0) constants.push_back({end, of_.start, {value}});
    std::vector<Signal> inputs;
    for (const Segment& one : constants) inputs.emplace_back(&one, 1, 0);
    std::vector<double> row(static_cast<std::size_t>(slow_.info().row_size()));
    Samples y(row.data(), slow_.info().row_size(), 1);
    slow_.advance(end, false, inputs, y);
    return row[Samples::header + displacements_[0].index];
  }

  void set_accelerance(std::size_t i, std::size_t k, double found) {
    const std::optional<double>& mass = entry_.links[i].effective.mass;
    if (mass && forces_.size() > 1)
      refuse(
          "has several links, whose masses depend on each other; allowed is links.effective_mass of one "
          "alone");
    const double value = i == k && mass ? 1.0 / *mass : found;
    if (i == k && found < 0.0)
      refuse(
          "accelerates by " + std::to_string(found) + " for a force of 1 at its input " +
          forces_[k].port->name +
          "; allowed is above 0, so that a sign of the input or of the output is to be turned (gain = -1)");
    if (i == k && !(value > 0.0))
      refuse("does not accelerate by its input " + forces_[k].port->name +
             " at once; allowed is one whose acceleration follows the force, or links.effective_mass");
    set(at("accelerance", i * forces_.size() + k), value);
  }

  const ImpulseEntry& entry_;
  const Scenario& of_;
  const Topology& topology_;
  std::function<Subsystem&(int)> subsystem_;
  Subsystem& slow_;
  std::vector<ScalarPort> forces_, displacements_, accelerances_;
  std::vector<Parameter> all_;
};

}  // namespace

std::unique_ptr<Subsystem> surrogate_of(const SubsystemEntry& entry, const Scenario& of,
                                        const Topology& topology,
                                        const std::vector<std::unique_ptr<Subsystem>>& subsystems,
                                        const Builtins& builtins) {
  const auto& links = entry.impulse->links;
  const auto subsystem = [&](const std::string& name) {
    const auto number = topology.instance(name);
    if (!number) refuse(entry.place, unknown("subsystem", name, topology.names()));
    return subsystems[static_cast<std::size_t>(*number)].get();
  };
  const auto lacks_fast = [&](const ImpulseEntry::Link& link) { return !subsystem(link.fast); };
  if (!subsystem(entry.impulse->slow) || std::any_of(links.begin(), links.end(), lacks_fast)) return nullptr;
  return located(entry.place, [&] {
    Opening opening;
    for (const Parameter& p : Asked(*entry.impulse, of, topology, [&](int i) -> Subsystem& {
                                return *subsystems[static_cast<std::size_t>(i)];
                              }).parameters())
      opening.parameters.set(p.name, p.value);
    return open(entry.source, builtins, std::move(opening));
  });
}

}  // namespace tandem::scenario
