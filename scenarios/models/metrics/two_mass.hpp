// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/study/coded_metric.hpp"

namespace tandem::two_mass {

/// What studies of the two-mass test may name (F. González, doctoral thesis, A Coruña 2010, chapter 5), with
/// the names of Settings as parameters. The fast side is the subsystem `fast` with the outputs x1, v1, the
/// slow one `slow` with x2, v2.
///   two_mass.exchange_energy_error  (FR/N) rms((E - E0)/E0) with the states that each side last computed,
///   after each
///                                   round; N the number of fast cycles (of 1 s each)
///   two_mass.amplitude_error,       of the fast mode: both modes at their exact frequencies fitted to x1 by
///   least squares two_mass.phase_error            over the last ten fast cycles; A/C11 - 1, and the lead in
///   rad within (-pi, pi]
void add_metrics(study::CodedMetrics& to);

}  // namespace tandem::two_mass
