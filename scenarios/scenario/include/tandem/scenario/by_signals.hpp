// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/scenario/scenario.hpp"

namespace tandem::scenario {

/// A scenario of an impulse coupling as one that is coupled by signals, with usual reconstructions where it has none; another
/// one as it is. What goes by outputs of a surrogate goes by those of its slow side; nothing is plotted or recorded of it.
Scenario by_signals(const Scenario& scenario);

}  // namespace tandem::scenario
