// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/engine/compiled_block.hpp"
#include "tandem/text/keys.hpp"

namespace tandem::engine {

/// The language of diagram files: what they and their blocks are read by. kinds: of blocks, besides the own
/// ones.
text::Keys diagram_keys(const std::vector<CompiledBlock>& kinds = {});

}  // namespace tandem::engine
