// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The ladder of a scenario in an FMU is nothing to the FMU.
#include "read_ladder.hpp"

namespace tandem::scenario {

void read_ladder(text::Section&, Scenario&) {}

}  // namespace tandem::scenario
