// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/scenario/sources.hpp"

namespace tandem {

/// Those of any scenario, and all that the scenes bring along: their models, elements of mechanisms and
/// compiled blocks of diagrams.
Builtins all_sources(const scenario::SourceSettings& settings = {});

}  // namespace tandem
