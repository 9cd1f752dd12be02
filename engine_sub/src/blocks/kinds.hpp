// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "arguments.hpp"

namespace tandem::engine {

/// A kind of block: what it comes down to.
struct BlockKind {
  const char* name;
  void (*lower)(Lowering& to, Arguments& a);
};

// By theme, one file each.
extern const std::vector<BlockKind> source_blocks, algebraic_blocks, table_blocks, nonlinear_blocks,
    dynamic_blocks, discrete_blocks, machine_blocks, nested_blocks;

/// A block by its kind.
void lower(const Block& block, Lowering& to);
/// What stands in a diagram: its blocks and limits.
void lower_contents(const Description& diagram, Lowering& to);
void lower_compiled(const CompiledBlock& kind, Lowering& to, Arguments& a);

}  // namespace tandem::engine
