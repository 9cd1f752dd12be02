// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "lowering.hpp"

namespace tandem::engine {

/// Refuses signals of Lowering::orders that are not in their order: both constant, or tables of the same
/// signal, at one of their points. Of others nothing is known before a run.
void refuse_disorder(const Lowering& diagram);

}  // namespace tandem::engine
