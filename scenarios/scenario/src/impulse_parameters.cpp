// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "impulse_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "slow_side.hpp"
#include "tandem/error.hpp"

namespace tandem::scenario {
namespace {

std::string text_of(double number) { return fmt::format("{:.6g}", number); }

class Asked {
 public:
  Asked(const ImpulseEntry& entry, const Scenario& of, const Topology& topology,
        std::function<Subsystem&(int)> subsystem)
      : entry_(entry),
        of_(of),
        topology_(topology),
        subsystem_(subsystem),
        slow_(entry, of, topology, subsystem(*topology.instance(entry.slow))) {}

  ImpulseCoupling coupling() {
    const Begin free = slow_.free();
    set_times(free);
    const std::size_t links = slow_.links();
    for (std::size_t k = 0; k < links; ++k)
      c_.links.push_back({slow_.force(k).port->unit, slow_.displacement(k).port->unit, derivative(free, k, 1),
                          derivative(free, k, 2), slow_.velocity_unit(k)});
    if (entry_.kind == ImpulseEntry::Kind::stiffness) set_springs();
    for (const ScalarPort& one : slow_.accelerances()) tell_accelerance(one, free);
    c_.accelerance.resize(links * links);
    for (std::size_t k = 0; k < links; ++k) set_accelerances(k, free);
    return std::move(c_);
  }

 private:
  double derivative(const Begin& begin, std::size_t link, std::size_t order) const {
    return slow_.derivative(begin, slow_.displacement(link), order);
  }

  void set_times(const Begin& free) {
    c_.own_step = fast_step(entry_, of_, topology_, subsystem_), c_.slow_step = free.step;
    slow_.require_longer_step(c_.slow_step, c_.own_step);
    c_.fast_period = of_.fast_period, c_.tells_velocities = slow_.has_velocities();
  }

  void set_springs() {
    const Springs found = springs_of(slow_, entry_.links[0].effective);
    c_.stiffness = {found.stiffness}, c_.damping = {found.damping};
    c_.degree = 4, c_.trapezoidal = found.trapezoidal, c_.spring_error = found.error;
  }

  void tell_accelerance(const ScalarPort& of, const Begin& free) {
    if (of.port->derivatives < 1)
      slow_.refuse("gives no derivative of its output " + of.port->name +
                   "; allowed in links.accelerance is one with it");
    c_.accelerance_rate.push_back(slow_.derivative(free, of, 1)),
        c_.accelerance_units.push_back(of.port->unit);
  }

  /// What a force of 1 at link k accelerates.
  void set_accelerances(std::size_t k, const Begin& free) {
    const Begin pushed = slow_.pushed(k, 1.0);
    const auto found = [&](std::size_t i) { return derivative(pushed, i, 2) - derivative(free, i, 2); };
    for (std::size_t i = 0; i < slow_.links(); ++i) {
      set_accelerance(i, k, found(i));
      if (!slow_.accelerances().empty()) check_told(i * slow_.links() + k, found(i), found(k), free);
    }
  }

  /// What the output tells is what a force has been found to do here; own: at its own displacement.
  void check_told(std::size_t e, double found, double own, const Begin& free) const {
    const double told = slow_.derivative(free, slow_.accelerances()[e], 0), off = std::abs(told - found);
    if (!(off <= 1e-6 * std::max({std::abs(told), std::abs(found), std::abs(own)})))
      slow_.refuse("starts with " + slow_.accelerances()[e].port->name + " = " + text_of(told) +
                   ", and accelerates by " + text_of(found) +
                   " for a force of 1; allowed in links.accelerance is the same to 1e-6");
  }

  void set_accelerance(std::size_t i, std::size_t k, double found) {
    const std::optional<double>& mass = entry_.links[i].effective.mass;
    if (mass && slow_.links() > 1)
      slow_.refuse(
          "has several links, whose masses depend on each other; allowed is links.effective_mass of one "
          "alone");
    const double value = i == k && mass ? 1.0 / *mass : found;
    if (mass) c_.found = found;
    if (i == k) slow_.require_reaction(k, found < 0.0 ? found : value);
    c_.accelerance[i * slow_.links() + k] = value;
  }

  const ImpulseEntry& entry_;
  const Scenario& of_;
  const Topology& topology_;
  std::function<Subsystem&(int)> subsystem_;
  SlowSide slow_;
  ImpulseCoupling c_;
};

}  // namespace

double fast_step(const ImpulseEntry& entry, const Scenario& of, const Topology& topology,
                 const std::function<Subsystem&(int)>& subsystem) {
  double shortest = of.stop - of.start;
  for (const ImpulseEntry::Link& link : entry.links) {
    const int fast = *topology.instance(link.fast);
    if (subsystem(fast).info().abilities.sampled)
      throw Error(ErrorCode::not_supported, "impulse coupling: the fast side '" + link.fast +
                                                "' is sampled; allowed is one that integrates itself");
    shortest = std::min(shortest, begin_of(subsystem(fast), topology.start(fast), of).step);
  }
  return shortest;
}

ImpulseCoupling impulse_coupling(const ImpulseEntry& entry, const Scenario& of, const Topology& topology,
                                 const std::function<Subsystem&(int)>& subsystem) {
  return Asked(entry, of, topology, subsystem).coupling();
}

}  // namespace tandem::scenario
