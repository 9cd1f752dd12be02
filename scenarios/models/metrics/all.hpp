// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/study/coded_metric.hpp"

namespace tandem {

/// All that the scenes bring along for studies.
study::CodedMetrics all_metrics();

}  // namespace tandem
