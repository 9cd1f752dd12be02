// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "lowering.hpp"

namespace tandem::engine {

/// Where an operation names the slots that it reads.
std::vector<int*> slots_of(Operation& operation);
std::vector<int> reads(Operation operation);

/// The step that makes each slot; -1 for none.
std::vector<int> makers(const Lowering& diagram);

/// What a step needs before it, resolved: what its operations read, and what stands together with that.
std::vector<int> needed_by(const Lowering& diagram, const Step& step);

/// By slot whether outputs depend on it, at once or later.
std::vector<bool> alive(const Lowering& diagram, const std::vector<int>& outputs);

/// Slots whose values these need at once, themselves among them.
std::vector<bool> needed_at_once(const Lowering& diagram, const std::vector<int>& slots);

/// Steps, by their numbers, in the order in which they are evaluated.
struct Sequence {
  std::vector<int> steps;
  std::vector<int> cuts = {};  ///< of a loop: signals whose last values are read before they are made
};

/// Those steps of `diagram` that make a slot in `wanted`, one after the other, each after those it reads. An
/// algebraic loop is one sequence if it is to be solved; else throws Error that names the blocks along it.
std::vector<Sequence> sorted_steps(const Lowering& diagram, const std::vector<bool>& wanted,
                                   const LoopSettings& loops);

/// The blocks of steps, each once: "a, b".
std::vector<std::string> blocks_of(const Lowering& diagram, const std::vector<int>& steps);

}  // namespace tandem::engine
