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

/// Values of coordination.order: the first is as the run has it, and in each of the others another subsystem leads. Nothing in
/// `parallel`, and of fewer than three that integrate themselves: there the schedule tells who leads.
std::vector<std::vector<std::string>> orders(const Coordinator& run);

}  // namespace tandem::advice
