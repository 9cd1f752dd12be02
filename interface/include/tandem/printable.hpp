// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace tandem {

/// A stranger's text as a terminal, a log and a file can take it:
/// - UTF-8 as it is;
/// - but control characters (also those that turn the direction of writing) as "\\x1b" or "\\u202e";
/// - bytes that are no UTF-8 as "\\xff";
/// - what is beyond `longest` bytes as "...".
std::string printable(std::string_view text, std::size_t longest = 2000);

/// All of a text of several lines, each printable.
std::string printable_lines(std::string_view text);

}  // namespace tandem
