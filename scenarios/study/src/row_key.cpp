// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "row_key.hpp"

#include <fmt/format.h>

namespace tandem::study {

std::string cell_of(const text::FileValue& value) {
  return std::visit([](const auto& one) { return fmt::format("{}", one); }, value);
}

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string out = "\"";
  for (const char c : cell) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string row_key(const std::vector<std::string>& columns, const text::FileValues& row) {
  std::string key;
  for (const std::string& column : columns) {
    if (&column != &columns.front()) key += ',';
    if (const auto it = row.find(column); it != row.end()) key += quoted(cell_of(it->second));
  }
  return key;
}

std::string row_text(const std::vector<std::string>& columns, const text::FileValues& row) {
  std::string text;
  for (const std::string& column : columns)
    if (const auto it = row.find(column); it != row.end())
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", column, cell_of(it->second));
  return text;
}

}  // namespace tandem::study
