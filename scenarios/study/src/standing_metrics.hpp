// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/scenario/scenario.hpp"

namespace tandem::study {

/// An output that rows are judged by.
struct JudgedOutput {
  std::string name;
  double tolerance;
  scenario::Measure measure;
};

/// The table [metrics] of a standing study: `error`, the largest part of a tolerance, `exchanges` and `own_steps`.
/// - is_judged: also `reference_error`, of the reference itself.
std::string standing_metrics(const std::vector<JudgedOutput>& judged, const scenario::Scenario& scenario,
                             bool is_judged);

/// The tables [names] and [[charts]].
std::string standing_charts(bool is_judged);

}  // namespace tandem::study
