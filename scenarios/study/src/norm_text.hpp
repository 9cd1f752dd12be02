// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/study/study.hpp"

namespace tandem::study {

/// What a metric is, in words: "largest difference of linkage.speed from fine, divided by its peak"; empty
/// for one that its name says.
std::string norm_text(const Metric& metric);

}  // namespace tandem::study
