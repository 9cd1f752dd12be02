// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/scenario/scenario.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::stability {

/// The scenario with coordination.fast_period, where an impulse coupling lacks it: the shortest period of the system undivided
/// in which fast sides take part, about its start, to four digits, as one that has been taken. Another scenario stays as it
/// is. Throws Error(not_supported), at coordination.coupling, where that system is not known or does not swing, else as
/// opening the scenario does.
scenario::Scenario with_fast_period(scenario::Scenario scenario, const Builtins& builtins);

}  // namespace tandem::stability
