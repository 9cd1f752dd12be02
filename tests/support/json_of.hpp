// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>

#include "scratch.hpp"

namespace tandem::test {

inline nlohmann::json json_of(const std::filesystem::path& file) {
  return nlohmann::json::parse(read_text(file));
}

}  // namespace tandem::test
