// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "output/keyed_table.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <string_view>

#include "tandem/error.hpp"
#include "tandem/input_file.hpp"
#include "tandem/output/files.hpp"

namespace tandem::output {
namespace {

/// At commas; what is beyond `most` cells stays in the last.
std::vector<std::string> split(const std::string& line, std::size_t most) {
  std::vector<std::string> cells(1);
  for (const char c : line)
    if (c == ',' && cells.size() < most)
      cells.emplace_back();
    else
      cells.back() += c;
  return cells;
}

bool is_right(const std::string& cell, std::string_view column) {
  constexpr std::array texts{"schedule", "to_fast", "to_slow", "note"};
  for (const std::string_view text : texts)
    if (column == text) return true;
  if (column == "status") return cell == "ok" || cell == "failed";
  double value = 0.0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return cell.empty() || (code == std::errc{} && end == cell.data() + cell.size());
}

}  // namespace

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

void KeyedTable::read(const std::filesystem::path& file) {
  InputFile in(file);
  std::string line;
  int number = 1;
  const auto fail = [&](const std::string& why) {
    throw Error(ErrorCode::input_output, fmt::format("{}:{}: {}", file.string(), number, why));
  };
  if (!in.line(line) || line != header_) fail("the header is not " + header_);
  const auto columns = split(header_, header_.size());
  while (in.line(line)) {
    ++number;
    const auto cells = split(line, columns.size() + 1);
    if (cells.size() != columns.size())
      fail(fmt::format("the row has {} cells{}; the header has {}", cells.size(),
                       cells.size() > columns.size() ? " or more" : "", columns.size()));
    std::size_t end = 0;
    for (int k = 0; k < key_cells_; ++k) end = line.find(',', end) + 1;
    for (std::size_t k = 0; k < cells.size(); ++k)
      if (!is_right(cells[k], columns[k]))
        fail(columns[k] + (columns[k] == "status" ? " is neither ok nor failed" : " is no number"));
    rows_[line.substr(0, end - 1)] = line.substr(end);
  }
}

void KeyedTable::write(const std::filesystem::path& file, const std::vector<std::string>& keys) const {
  std::string text = header_ + '\n';
  for (const std::string& key : keys)
    if (const auto it = rows_.find(key); it != rows_.end()) text += key + ',' + it->second + '\n';
  replace_text(file, text);
}

}  // namespace tandem::output
