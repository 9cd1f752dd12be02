// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <toml++/toml.h>

#include <nlohmann/json.hpp>

namespace tandem::scenario {

/// The same values, in the order of the file.
nlohmann::ordered_json to_json(const toml::node& node);

}  // namespace tandem::scenario
