// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/study/study.hpp"
#include "tandem/text/section.hpp"

namespace tandem::study {

/// [choices], when tables, columns and metrics are known.
void read_choices(text::Section& root, Study& to);

}  // namespace tandem::study
