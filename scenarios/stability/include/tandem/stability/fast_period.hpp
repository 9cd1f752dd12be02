// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/scenario/scenario.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::stability {

/// The scenario with coordination.fast_period, where an impulse coupling lacks it: the shortest period of the system undivided,
/// about its start, as one that has been taken. Another scenario stays as it is. Throws Error, at coordination.coupling, where
/// that system is not known or does not swing.
scenario::Scenario with_fast_period(scenario::Scenario scenario, const Builtins& builtins);

/// The same scenario, coupled by signals, with usual reconstructions where it has none. What goes by outputs of a surrogate
/// goes by those of its slow side; nothing is plotted or recorded of it.
scenario::Scenario by_signals(const scenario::Scenario& scenario);

}  // namespace tandem::stability
