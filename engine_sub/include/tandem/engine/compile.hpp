// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/engine/description.hpp"
#include "tandem/engine/program.hpp"

namespace tandem::engine {

/// Checks a diagram and sorts it by direct feedthrough. What feeds no output is left out, with a notice.
/// Throws Error(invalid_argument) with the place and name of a block for:
/// - a kind, key or signal that is not there;
/// - a value that is not allowed;
/// - a name that is there twice;
/// - an algebraic loop, with the blocks along it.
Program compile(const Description& diagram);

}  // namespace tandem::engine
