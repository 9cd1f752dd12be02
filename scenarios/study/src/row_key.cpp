// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "row_key.hpp"

#include <fmt/format.h>

#include "tandem/charts/csv_table.hpp"

namespace tandem::study {

std::string cell_of(const text::FileValue& value) {
  return std::visit([](const auto& one) { return fmt::format("{}", one); }, value);
}

std::string row_key(const std::vector<std::string>& columns, const text::FileValues& row) {
  std::string key;
  for (const std::string& column : columns) {
    if (&column != &columns.front()) key += ',';
    if (const auto it = row.find(column); it != row.end()) key += charts::csv_cell(cell_of(it->second));
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
