// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/engine/program.hpp"

namespace tandem::engine {

/// The least time between two different instants of the periodic events [s], of one or more of them. Throws
/// Error(invalid_argument) where two periods have no common measure, so that instants come as near to each
/// other as one likes.
double shortest_period(const Program& program);

}  // namespace tandem::engine
