// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "lowering.hpp"

namespace tandem::engine {

/// What a block of certain kinds gives has the unit of what it takes: of a sum without gains, a saturation,
/// ...
void keep_units(const Block& block, Lowering& to);

/// Refuses ports that say different units of one signal, or of signals that keep_units() has joined.
void refuse_mixed_units(const Lowering& lowered);

}  // namespace tandem::engine
