// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <charconv>
#include <string>

namespace tandem {

/// The shortest text that reads back as this number: 1e-20 where std::to_string gives 0.000000.
inline std::string number_text(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

}  // namespace tandem
