// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "four_bar/study.hpp"

namespace tandem::four_bar {

inline constexpr double sweep_end = 20.0;   // [s]
inline constexpr double sweep_alpha = 1e8;  // the penalty, where nothing else is said

/// The runs of `tandem sweep four_bar`: the index-3 formulation for every number of loops, step and
/// tolerance; with other settings; and each other formulation with each integrator, for few loops.
std::vector<Case> sweep_cases();
/// Roughly the time of a run on one core [s].
double sweep_cost(const Case& c);

/// results/mbs/four_bar.csv. order: log2 of the ratio of the errors with twice the step and with this one, if
/// both reached the end. Figures of a run that did not are those of its last state, at the time `end`,
/// without the error of x.
std::string sweep_table(const std::vector<Case>& cases, const std::vector<Result>& results);

/// results/mbs/four_bar_traces.csv: two loops over the first two passages of the flat position, each
/// formulation with each integrator.
void write_traces(const std::filesystem::path& file);

}  // namespace tandem::four_bar
