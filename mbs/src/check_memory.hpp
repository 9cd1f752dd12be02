// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/error.hpp"

namespace tandem::mbs {

/// Throws Error(invalid_argument) for memory (Stepper::memory) that is not of one's own kind.
inline void check_memory(bool fits) {
  if (!fits)
    throw Error(ErrorCode::invalid_argument,
                "the state is not whole, or that of another model or of a stepper with other settings");
}

}  // namespace tandem::mbs
