// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cctype>
#include <string>

namespace tandem::test {

/// The text as the name of a test's parameter: letters, digits and underscores.
inline std::string word(std::string text) {
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return text;
}

}  // namespace tandem::test
