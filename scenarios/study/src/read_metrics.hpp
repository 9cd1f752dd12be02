// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/study/study.hpp"
#include "tandem/text/section.hpp"

namespace tandem::study {

/// The table [metrics] of a study whose tables and references were read.
void read_metrics(text::Section& root, Study& to);

/// Throws Error for a name that is neither a column nor one of the metrics that were read.
void check_formula(const Formula& formula, const std::string& what, const Study& study);

}  // namespace tandem::study
