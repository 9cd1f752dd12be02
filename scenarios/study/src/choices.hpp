// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/study/study.hpp"

namespace tandem::study {

/// The file of a choice, as CSV, from those of its tables in a folder: the columns in `per`, then
/// `advised,best,advised_error,best_error,rank`. A scheme is the cells of the other columns with spaces between, and its
/// rank 1 more than the number of those with a smaller error. What has no value counts as infinite.
std::string choices_text(const Choice& choice, const Study& study, const std::filesystem::path& folder);

}  // namespace tandem::study
