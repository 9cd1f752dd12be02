// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/coordinator/coordinator.hpp"

namespace tandem::advice {

/// What is sure of a run that is initialized, without a trial, in sentences:
/// - rings of any length in which a leader feeds an input through that it extrapolates;
/// - the order in which subsystems with events lead their readers.
std::vector<std::string> on_leading(const Coordinator& run);

/// coordination.order in which subsystems with events lead those without that read them, in the schedule of the run; nothing
/// where they do, or where nobody leads.
std::vector<std::string> better_order(const Coordinator& run);

/// Of three subsystems and more that integrate themselves in a schedule in which one leads: coordination.order as the run
/// has it, then for each of those that do not lead by it the order in which that one does. Of others nothing.
std::vector<std::vector<std::string>> orders(const Coordinator& run);

}  // namespace tandem::advice
