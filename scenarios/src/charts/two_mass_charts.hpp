// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "charts/gnuplot.hpp"
#include "charts/two_mass_data.hpp"

namespace tandem::charts {

using Caption = std::vector<std::string>;

// The charts of the two-mass three-spring test. `caption` are the conditions, which stand at the foot of
// each. Each throws Error if the rows that it is to show are not there.

/// Position and energy error over the frequency ratio, slowest-first and fastest-first, a curve for each
/// degree.
Picture errors_chart(const std::vector<Result>& sweep, const Caption& caption);
/// x1 over the first 20 fast cycles at FR 90 against the exact motion, a panel for each scheme traced there.
Picture motion_fr90_chart(const std::vector<Trace>& traces, const Caption& caption);
/// x1 over time at FR 30: the whole run and its last ten fast cycles, for each scheme traced there.
Picture motion_fr30_chart(const std::vector<Trace>& traces, const Caption& caption);
/// Energy error over time at FR 30, cubic polynomials both ways.
Picture energy_fr30_chart(const std::vector<Trace>& traces, const Caption& caption);
/// Error against run time and against exchanges, all schemes and step sizes.
Picture work_precision_chart(const std::vector<Result>& work, const Caption& caption);
/// The error of each scheme at each frequency ratio, with the best one marked.
Picture best_scheme_chart(const std::vector<Result>& sweep, const Caption& caption);

}  // namespace tandem::charts
