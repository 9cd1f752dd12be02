// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/coordinator/topology.hpp"

namespace tandem {

/// Two lines between the same two subsystems, one each way, that together carry a power.
struct PowerLink {
  enum class Kind {
    flow,          ///< an effort (force, torque, voltage), and back a flow (speed, angular speed, current)
    displacement,  ///< an effort, and back a displacement (length, angle)
    stiffness,     ///< a displacement each way, of the ends of a spring
  };
  Kind kind;
  int effort, back;  ///< numbers of lines; of `stiffness` either is either
  /// Power [W] per unit of the effort's reader and unit of what comes back (of a displacement: its rate); of
  /// `stiffness` likewise, with the spring's [N/m, N m/rad].
  double scale;
};

/// The lines that carry a power by their units (energy_product), each of them with one other alone: a line that
/// would go with several is in none. A flow goes before a displacement. Of arrays of equal size the same elements go
/// together. Held outputs carry none.
std::vector<PowerLink> power_links(const Topology& topology);

/// What a scenario states: outputs, "instance.port" or "instance.port[i]", of two subsystems that read each other's.
struct StatedLink {
  std::string effort, back;
  PowerLink::Kind kind;
  double stiffness = 1.0;  ///< [N/m, N m/rad]
};
/// Throws Error for an output that is not there, or that the other's subsystem does not read by one line that is not
/// held, and for units whose product is no power. Ports that say no units count as SI.
PowerLink power_link(const Topology& topology, const StatedLink& link);

/// "EFFORT:BACK": names of the outputs.
std::string name_of(const Topology& topology, const PowerLink& link);

}  // namespace tandem
