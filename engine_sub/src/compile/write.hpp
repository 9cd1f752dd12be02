// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "lowering.hpp"

namespace tandem::engine {

/// Gives the signals that outputs depend on their places in an image, and puts what is done with them in
/// order.
Program write_program(Lowering& lowered, const std::vector<int>& outputs, const LoopSettings& loops);

}  // namespace tandem::engine
