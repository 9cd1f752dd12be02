// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A scenario in an FMU is coupled by signals.
#include "impulse.hpp"

namespace tandem::scenario {

void couple_by_impulse(const std::string& coupling, Scenario& to) {
  refuse(to.place("coordination.coupling"),
         "coordination.coupling is " + coupling + ", which an FMU can't be coupled by; allowed is signals");
}

Surrogate surrogate_of(const SubsystemEntry&, const Scenario&, const Topology&,
                       const std::vector<std::unique_ptr<Subsystem>>&) {
  return {};
}

std::string reactive_obstacle(const Scenario&, const Topology&, const std::vector<Surrogate>&) { return {}; }

std::vector<Guest> make_reactive(const Scenario&, const Topology&, const std::vector<Surrogate>&,
                                 std::vector<std::unique_ptr<Subsystem>>&) {
  return {};
}

}  // namespace tandem::scenario
