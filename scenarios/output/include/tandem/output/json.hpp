// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace tandem::output {

/// JSON of others, its keys sorted: to find one takes no longer the more there are. What compares, copies and
/// prints it goes down its objects and arrays one call each: more than deepest_json in each other are
/// refused. Throws Error(input_output) that begins with `name` and quotes nothing of it.
inline constexpr int deepest_json = 200;
nlohmann::json parse_json(std::string_view text, const std::string& name);

/// Of a file, which has to be a regular one.
nlohmann::json read_json(const std::filesystem::path& file);

/// What made results: tandem's version, commit, compiler, processor.
nlohmann::ordered_json made();

}  // namespace tandem::output
