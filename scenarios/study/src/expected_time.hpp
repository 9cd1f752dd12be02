// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/scenario/assembly.hpp"

namespace tandem::study {

/// What the rounds of a run will take [s], by what its first ones take: those of up to `patience` s. The run is not
/// of use afterwards. Precondition: it is initialized.
double expected_seconds(scenario::Assembly& run, double start, double stop, double patience);

}  // namespace tandem::study
