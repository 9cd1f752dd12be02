// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tandem::test {

/// A stranger's text, and how it has to be shown.
struct ShownText {
  std::string text, shown;
};

/// Those of tests/support/printable.txt.
inline std::vector<ShownText> printable_table() {
  std::ifstream file(TANDEM_SOURCE_DIR "/tests/support/printable.txt");
  std::vector<ShownText> table;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    const auto bar = line.find(" | ");
    std::istringstream numbers(line.substr(0, bar));
    std::string text;
    for (unsigned byte; numbers >> std::hex >> byte;) text += static_cast<char>(byte);
    table.push_back({text, bar == std::string::npos ? text : line.substr(bar + 3)});
  }
  if (table.empty()) throw std::runtime_error("the table of texts is not there");
  return table;
}

}  // namespace tandem::test
