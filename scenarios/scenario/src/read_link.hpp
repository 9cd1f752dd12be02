// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/scenario/scenario.hpp"
#include "tandem/text/section.hpp"

namespace tandem::scenario {

/// A table of [[links]].
LinkEntry read_link(text::Section& section);

}  // namespace tandem::scenario
