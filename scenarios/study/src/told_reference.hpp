// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "hand_out.hpp"
#include "references.hpp"

namespace tandem::study {

/// A reference that was made, as ranks tell it each other; and back, with the same bits.
Told told(const ReferenceRun& run);
void take(const Told& made, ReferenceRun& run);

}  // namespace tandem::study
