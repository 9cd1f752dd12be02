// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/scenario/scenario.hpp"
#include "tandem/text/section.hpp"

namespace tandem::scenario {

/// The table [ladder]: `set`, overrides of all rungs; [[ladder.judged]] with `quantity`, `tolerance` and
/// `unit`, absent: what [judge] says; [[ladder.rungs]] from simple to rich with `name`, `file` (default: this
/// one), `set`, and `outputs`, where a judged quantity has another name. Throws Error.
void read_ladder(text::Section& section, Scenario& to);

}  // namespace tandem::scenario
