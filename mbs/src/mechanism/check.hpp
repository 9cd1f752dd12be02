// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/mechanism/description.hpp"

namespace tandem::mbs {

/// Throws Error where nothing moves, for points without mass, angles and lengths that are not defined as
/// drawn, and bodies that are connected to nothing while they don't say that they are free.
void check(const Description& in);

}  // namespace tandem::mbs
