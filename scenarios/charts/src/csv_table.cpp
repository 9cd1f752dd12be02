// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/csv_table.hpp"

#include <charconv>
#include <cmath>
#include <limits>

#include "tandem/error.hpp"
#include "tandem/input_file.hpp"

namespace tandem::charts {
namespace {

constexpr std::size_t most_cells = 100'000;  // of a row

}  // namespace

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

CsvTable CsvTable::read(const std::filesystem::path& file, const std::vector<std::string>& columns) {
  InputFile in(file);
  CsvTable table(file);
  std::string line;
  in.line(line);
  table.take_header(line, columns);
  while (in.line(line)) table.take_row(line);
  return table;
}

void CsvTable::refuse(std::size_t line, const std::string& why) const {
  throw Error(ErrorCode::input_output,
              "file '" + file_.string() + "', line " + std::to_string(line) + ": " + why);
}

std::vector<std::string> CsvTable::cells_of(const std::string& line, std::size_t number) const {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && line.compare(i + 1, 1, "\"") == 0)
      cells.back() += line[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted && cells.size() == most_cells)
      refuse(number, "more than " + std::to_string(most_cells) + " cells, the most allowed");
    else if (c == ',' && !quoted)
      cells.emplace_back();
    else if (c != '\r')
      cells.back() += c;
  }
  if (quoted) refuse(number, "a cell in quotes does not end");
  return cells;
}

void CsvTable::take_header(const std::string& line, const std::vector<std::string>& required) {
  names_ = cells_of(line, 1);
  for (const std::string& name : names_)
    if (!columns_.emplace(name, columns_.size()).second)
      refuse(1, "the name of column " + std::to_string(columns_.size() + 1) + " stands there twice");
  for (const std::string& name : required)
    if (columns_.count(name) == 0) refuse(1, "column '" + name + "' is missing");
}

void CsvTable::take_row(const std::string& line) {
  const std::size_t number = rows_.size() + 2;
  rows_.push_back(cells_of(line, number));
  if (rows_.back().size() != columns_.size())
    refuse(number,
           std::to_string(rows_.back().size()) + " cells; the header has " + std::to_string(columns_.size()));
}

const std::string& CsvTable::Row::text(std::string_view column) const {
  const auto found = table_.columns_.find(column);
  if (found == table_.columns_.end()) table_.refuse(1, "column '" + std::string(column) + "' is missing");
  return table_.rows_[index_][found->second];
}

const std::string& CsvTable::Row::name(std::string_view column) const {
  const std::string& cell = text(column);
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
  if (cell.find_first_not_of(allowed) != std::string::npos || cell.empty())
    refuse(column, "a name of letters, digits and _");
  return cell;
}

void CsvTable::Row::refuse(std::string_view column, const std::string& allowed) const {
  table_.refuse(index_ + 2, std::string(column) + " is something else; allowed is " + allowed);
}

double CsvTable::Row::number(std::string_view column) const {
  const std::string& cell = text(column);
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  double value = 0.0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (code != std::errc() || end != cell.data() + cell.size()) refuse(column, "a number, or nothing");
  return value;
}

double CsvTable::Row::positive(std::string_view column) const {
  const double value = number(column);
  if (!(value > 0.0) || !std::isfinite(value)) refuse(column, "a number above 0");
  return value;
}

}  // namespace tandem::charts
