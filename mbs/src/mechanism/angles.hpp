// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "constraint_set.hpp"
#include "tandem/mbs/mechanism/numbering.hpp"

namespace tandem::mbs {

/// The definitions of angles, added to the structure's lists.
std::unique_ptr<ConstraintSet> angle_set(const Description& in, const Numbering& at, Structure& structure);
/// Constant angles in space, added too; none in the plane, where they are of second degree (equations.hpp).
/// Throws Error for an angle of 0 or pi.
std::unique_ptr<ConstraintSet> fixed_angle_set(const Description& in, const Numbering& at,
                                               Structure& structure);

}  // namespace tandem::mbs
