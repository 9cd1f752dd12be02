// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "tandem/text/key_list.hpp"
#include "tandem/text/section.hpp"
#include "tandem/time_series.hpp"

namespace tandem::text {

/// The words for how values are joined and what holds beyond them, as every language of files has them.
void keys_of_joining(KeyList& to, const std::string& beyond = "refuse");
/// Those, and the keys of a quantity that is data over time: `file` and `column`, or `times` and `values`.
void keys_of_series(KeyList& to);

/// What keys_of_series() say in a section; none if neither `file` nor `times` is there. `folder`: that of
/// relative files.
std::optional<TimeSeries> read_series(Section& section, const std::filesystem::path& folder);

/// A column of a CSV file (TimeTable). Throws Error that names the file.
TimeSeries column_series(const std::filesystem::path& file, const std::string& column, TimeSeries::How how);

}  // namespace tandem::text
