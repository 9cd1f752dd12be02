// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/study/study.hpp"
#include "tandem/text/section.hpp"

namespace tandem::study {

/// What a key is set to; nothing if it is not there.
std::optional<Given> one_given(text::Section& section, const std::string& key);
/// What the keys of a table are set to, in the order of the file.
std::vector<Given> all_given(text::Section& section, const std::string& key);

/// Throws Error for a column that no table of the study has; `what` is what the sentence calls it.
void check_column(const Place& place, const std::string& what, const std::string& column, const Study& study);
/// Likewise for those that something stands for; table: "set.".
void check_columns(const Given& one, const std::string& table, const Study& study);

}  // namespace tandem::study
