// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/scenario/scenario.hpp"

namespace tandem::scenario {

/// The scheme of a source that is a scenario.
inline constexpr const char* nested_scheme = "scenario";

/// Throws Error for a scenario that stands in itself, by way of others,and for one of too many subsystems or levels.
void check_nesting(const Scenario& scenario);

}  // namespace tandem::scenario
