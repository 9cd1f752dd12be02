// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>

#include "tandem/fixed_step.hpp"

namespace tandem::fmi {

/// The mean of a signal over a step, exact for each of its polynomial pieces (Gauss' rule of three points).
double mean_over(const Signal& signal, const OwnStep& s);

/// From the piece on that holds after the step's begin. (At a break a signal has the piece before it.)
Signal from_begin(const Signal& signal, const OwnStep& s);

}  // namespace tandem::fmi
