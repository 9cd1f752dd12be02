// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "impulse.hpp"
#include "tandem/error.hpp"

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
        const std::function<Subsystem&(int)>& subsystem)
      : entry_(entry),
        of_(of),
        topology_(topology),
        subsystem_(subsystem),
        slow_(subsystem(*topology.instance(entry.slow))) {
    for (const ImpulseEntry::Link& link : entry.links) {
      forces_.push_back(found(slow_.info().inputs, "input", link.force));
      displacements_.push_back(found(slow_.info().outputs, "output", link.displacement));
    }
  }

  std::vector<Parameter> parameters() {
    check_slow();
    std::vector<double> u0 = topology_.start(*topology_.instance(entry_.slow));
    for (const ScalarPort& force : forces_) u0[force.index] = 0.0;
    const Begin free = begin_of(slow_, u0, of_);
    set("own_step", fast_step()), set("slow_step", free.step), set("fast_period", of_.fast_period);
    for (std::size_t k = 0; k < forces_.size(); ++k) {
      set(at("force_unit", k), forces_[k].port->unit),
          set(at("displacement_unit", k), displacements_[k].port->unit);
      set(at("velocity", k), derivative(free, k, 1)), set(at("free_acceleration", k), derivative(free, k, 2));
    }
    for (std::size_t k = 0; k < forces_.size(); ++k) {
      u0[forces_[k].index] = 1.0;
      const Begin pushed = begin_of(slow_, u0, of_);
      u0[forces_[k].index] = 0.0;
      for (std::size_t i = 0; i < forces_.size(); ++i)
        set_accelerance(i, k, derivative(pushed, i, 2) - derivative(free, i, 2));
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
    const double value =
        begin.row[order * static_cast<std::size_t>(slow_.info().output_size()) + displacements_[link].index];
    if (!std::isfinite(value))
      refuse("starts with a derivative of " + displacements_[link].port->name +
             " that is not finite, as another input is not known; allowed is a start value of each");
    return value;
  }

  void set_accelerance(std::size_t i, std::size_t k, double found) {
    const std::optional<double>& stated = entry_.links[i].accelerance;
    const double value = i == k && stated ? *stated : found;
    if (i == k && !(value > 0.0))
      refuse("does not accelerate by its input " + forces_[k].port->name +
             " at once; allowed is one whose acceleration follows the force, or links.accelerance");
    set(at("accelerance", i * forces_.size() + k), value);
  }

  const ImpulseEntry& entry_;
  const Scenario& of_;
  const Topology& topology_;
  const std::function<Subsystem&(int)>& subsystem_;
  Subsystem& slow_;
  std::vector<ScalarPort> forces_, displacements_;
  std::vector<Parameter> all_;
};

}  // namespace

std::vector<Parameter> parameters_of_surrogate(const ImpulseEntry& entry, const Scenario& of,
                                               const Topology& topology,
                                               const std::function<Subsystem&(int)>& subsystem) {
  return Asked(entry, of, topology, subsystem).parameters();
}

}  // namespace tandem::scenario
