// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace tandem::scenario {

/// results.json of a folder. What is read of it later is there and of its type. Throws Error that names the
/// file, and the key that is not as a run writes it.
nlohmann::json read_about(const std::filesystem::path& folder);

/// Of a folder of a run, or a CSV file in one, of which the run did not come to its end, a sentence; else
/// empty.
std::string unfinished(const std::filesystem::path& place);

}  // namespace tandem::scenario
