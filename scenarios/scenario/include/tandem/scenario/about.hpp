// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tandem/text/time_table.hpp"

namespace tandem::scenario {

/// results.json of a folder. What is read of it later is there and of its type. Throws Error that names the
/// file, and the key that is not as a run writes it.
nlohmann::json read_about(const std::filesystem::path& folder);

/// Names of the files of rows that results.json of a folder tells; none where it is not there or is damaged.
std::vector<std::string> files_of(const std::filesystem::path& folder);

/// Of a folder of a run, or a CSV file in one, of which the run did not come to its end, a sentence; else
/// empty.
std::string unfinished(const std::filesystem::path& place);

/// Results to be relied on, as text::TimeTable::read. Throws Error also for those of a run that did not come to its end.
text::TimeTable read_finished(const std::filesystem::path& place);

/// Of a run's indicators what stands under its curves: the two defects and the energy that are the largest parts of what
/// they are of. Names of columns of indicators.csv in the folder; empty where there is none.
std::vector<std::string> largest_indicators(const nlohmann::json& about, const std::filesystem::path& folder);

}  // namespace tandem::scenario
