// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>

namespace tandem::view {

/// results.json of a folder. What is read of it later is there and of its type. Throws Error that names the
/// file, and the key that is not as a run writes it.
nlohmann::json read_about(const std::filesystem::path& folder);

}  // namespace tandem::view
