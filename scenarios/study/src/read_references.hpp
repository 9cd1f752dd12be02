// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/study/study.hpp"
#include "tandem/text/section.hpp"

namespace tandem::study {

/// The table [references] of a study whose tables were read.
void read_references(text::Section& root, Study& to);

}  // namespace tandem::study
