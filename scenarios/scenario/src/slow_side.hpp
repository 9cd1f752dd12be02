// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tandem/coordinator/topology.hpp"
#include "tandem/scenario/scenario.hpp"

namespace tandem::scenario {

/// How a subsystem starts.
struct Begin {
  std::vector<double> row;  ///< outputs, then derivatives
  double step;              ///< its first own step [s]
};
Begin begin_of(Subsystem& subsystem, std::span<const double> u0, const Scenario& of);

/// A scalar of a port that is named whole, "slow.x2", or with its element.
struct ScalarPort {
  const Port* port;
  std::size_t index;  ///< flattened
};

/// The slow side of an impulse coupling before the run, with its links: how it starts and moves by forces there. Inputs that
/// are no link have what they start with. Throws Error(not_supported) that names it for what can't be coupled so.
class SlowSide {
 public:
  /// Precondition: all of them outlive it, and the topology has the instance.
  SlowSide(const ImpulseEntry& entry, const Scenario& of, const Topology& topology, Subsystem& slow);

  std::size_t links() const { return forces_.size(); }
  const ScalarPort& force(std::size_t link) const { return forces_[link]; }
  const ScalarPort& displacement(std::size_t link) const { return displacements_[link]; }
  /// Whether velocities are wanted at some links, and the unit of one.
  bool has_velocities() const;
  std::string velocity_unit(std::size_t link) const;
  /// Outputs that tell what forces accelerate, by rows of links; empty: there are none.
  const std::vector<ScalarPort>& accelerances() const { return accelerances_; }
  /// An output of one number. Throws Error(not_supported) if there is none of that name.
  ScalarPort output(const std::string& name) const { return found(slow_.info().outputs, "output", name); }
  /// Throws Error(not_supported) that names them for a force of 1 at that link that does not accelerate it forward, and for steps
  /// that are no longer than those of the fast side [s].
  void require_reaction(std::size_t link, double acceleration) const;
  void require_longer_step(double own, double fast) const;
  [[noreturn]] void refuse(const std::string& why) const;

  /// Its start without a force at the links, and with one.
  Begin free() { return pushed(0, 0.0); }
  Begin pushed(std::size_t link, double force);
  /// A derivative of an output there, 0 for itself.
  double derivative(const Begin& begin, const ScalarPort& of, std::size_t order) const;

  /// A force at its only link that moves the displacement within a step by a small part of its size.
  double small_force();
  /// By how much that force moves the displacement, its speed and its acceleration within so long, within twice and three
  /// times so long: beside no force.
  struct Moved {
    double y[3], v[3], a[3];
  };
  Moved moved_by(double force, double length);
  bool lands() const { return slow_.info().abilities.lands; }

 private:
  ScalarPort found(const std::vector<Port>& ports, const char* what, const std::string& name) const;
  void check() const;
  Moved after(double force, double length);

  const ImpulseEntry& entry_;
  const Scenario& of_;
  Subsystem& slow_;
  std::vector<ScalarPort> forces_, displacements_, accelerances_;
  std::vector<double> u0_;  ///< without forces at the links
};

/// What a slow side's only link hangs on: a mass of 1 / accelerance on a spring and a damper.
struct Springs {
  double stiffness, damping;
  bool trapezoidal;  ///< its rule takes the mean of the positions at the ends of its step
  double error;      ///< part of what they accelerate, where a force has pushed it for up to three steps
};
/// stated: in place of what is found.
Springs springs_of(SlowSide& slow, const Effective& stated);

}  // namespace tandem::scenario
