// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/study/study.hpp"
#include "tandem/text/section.hpp"

namespace tandem::study {

/// The tables [[keep]] of a study of which all else is read.
void read_kept(text::Section& root, Study& to);

}  // namespace tandem::study
