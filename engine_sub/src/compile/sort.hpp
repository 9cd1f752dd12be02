// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "lowering.hpp"

namespace tandem::engine {

/// Where an operation names the slots that it reads.
std::vector<int*> slots_of(Operation& operation);
std::vector<int> reads(Operation operation);

/// By slot whether outputs depend on it, at once or later.
std::vector<bool> alive(const Lowering& diagram, const std::vector<int>& outputs);

/// Slots whose values these need at once, themselves among them.
std::vector<bool> needed_at_once(const Lowering& diagram, const std::vector<int>& slots);

/// The numbers of those steps of `diagram` that make a slot in `wanted`, each after those it reads. Throws
/// Error that names the blocks along an algebraic loop.
std::vector<int> sorted_steps(const Lowering& diagram, const std::vector<bool>& wanted);

}  // namespace tandem::engine
