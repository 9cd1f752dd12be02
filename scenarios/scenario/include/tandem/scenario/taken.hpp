// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/scenario/scenario.hpp"

namespace tandem::scenario {

/// A scenario that chooses, with usual values for what it leaves out: it runs.
Scenario with_usual(Scenario scenario);

/// The scenario with what coordination.scheme = "auto" has taken, besides what it has taken before. Throws Error for an
/// override of another key than those of a scheme.
Scenario with_taken(const Scenario& scenario, std::vector<std::string> taken);

/// Puts the fast period that an impulse coupling lacks [s], as one that has been taken.
void take_fast_period(Scenario& scenario, double period);

}  // namespace tandem::scenario
