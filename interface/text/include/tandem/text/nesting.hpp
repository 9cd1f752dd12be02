// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string_view>

namespace tandem::text {

/// Tables and arrays that stand in each other: what reads, prints and forgets a document goes down them one
/// call each, so their number is bounded.
inline constexpr int deepest_nesting = 100;
inline constexpr const char* too_deep = "tables and arrays stand in each other more than 100 deep";

/// Bytes of the longest TOML file.
inline constexpr std::uint64_t longest_document = std::uint64_t{1} << 26;

/// The first line of a TOML text in which more than `most` tables and arrays stand in each other, by brackets
/// and by the dots of keys; 0 if there is none. Of what is not TOML it may name a line that is not so deep.
int deeper_than(std::string_view toml, int most);

}  // namespace tandem::text
