// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/study/study.hpp"
#include "tandem/text/section.hpp"

namespace tandem::study {

/// Of one of [[search]], but for its axes.
Search read_search(text::Section& section);

}  // namespace tandem::study
