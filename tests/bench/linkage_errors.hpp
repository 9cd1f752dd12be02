// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "bench/bench.hpp"
#include "four_bar/study.hpp"

namespace tandem::bench {

/// The runs of `tandem bench linkage_errors`: the index-3 formulation for every number of loops, step and
/// tolerance; with other settings; and each other formulation with each integrator, for few loops.
std::vector<four_bar::Case> error_cases();

/// order: log2 of the ratio of the errors with twice the step and with this one, if both reached the end.
/// Figures of a run that did not are those of its last state, at the time `end`, without the error of x.
Table error_table(const std::vector<four_bar::Case>& cases, const std::vector<four_bar::Result>& results);

}  // namespace tandem::bench
