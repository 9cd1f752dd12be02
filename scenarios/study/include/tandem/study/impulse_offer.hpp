// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/scenario/scenario.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::study {

/// What makes a scenario that is coupled by signals one of impulse coupling, as overrides. coupling: a word of
/// coordination.coupling.
std::vector<std::string> impulse_overrides(const std::string& coupling);

/// Which impulse couplings can be tried with a scenario that is coupled by signals.
struct ImpulseOffer {
  std::vector<std::string> couplings = {};  ///< words of coordination.coupling, the first is `impulse`; empty: none
  double fast_period = 0.0;                 ///< [s], stated or found
  std::string obstacle = {};                ///< why none

  bool holds() const { return !couplings.empty(); }
};
ImpulseOffer impulse_offer(const scenario::Scenario& scenario, const Builtins& builtins);

/// Whether an input, "fast.x2", is fed by an output of its [[links]].
bool is_of_link(const scenario::Scenario& scenario, const std::string& to);
/// Whether an output is the displacement or the velocity of one of them. By impulse it has not what the fast side does to it;
/// its surrogate has.
bool is_back_of_link(const scenario::Scenario& scenario, const std::string& output);

}  // namespace tandem::study
