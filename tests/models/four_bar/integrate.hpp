// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "four_bar/course.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/stepper.hpp"

namespace tandem::four_bar {

/// The linkage, assembled from text(), by a stepper of it in so many equal steps to the time `end` [s].
Course integrate(const mbs::Mechanism& linkage, mbs::Stepper& stepper, double end, long steps);

}  // namespace tandem::four_bar
