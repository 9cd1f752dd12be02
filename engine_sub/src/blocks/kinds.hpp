// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "arguments.hpp"
#include "tandem/text/key_list.hpp"

namespace tandem::engine {

/// A kind of block: what it comes down to, what it is, and the keys that it is read by.
struct BlockKind {
  const char* name;
  void (*lower)(Lowering& to, Arguments& a);
  const char* sentence;
  void (*keys)(text::KeyList& to);
};
using Type = text::Key::Type;

// By theme, one file each.
extern const std::vector<BlockKind> source_blocks, algebraic_blocks, table_blocks, nonlinear_blocks,
    dynamic_blocks, discrete_blocks, machine_blocks, nested_blocks;

/// All of them.
const std::vector<BlockKind>& kinds_of_blocks();
/// A block by its kind.
void lower(const Block& block, Lowering& to);
/// What stands in a diagram: its blocks and limits.
void lower_contents(const Description& diagram, Lowering& to);
void lower_compiled(const CompiledBlock& kind, Lowering& to, Arguments& a);

}  // namespace tandem::engine
