// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "table_rows.hpp"

#include <fmt/format.h>

#include "row_key.hpp"
#include "tandem/charts/csv_table.hpp"
#include "tandem/input_file.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/json.hpp"

namespace tandem::study {
namespace {

namespace fs = std::filesystem;

constexpr char between =
    '\x1f';  // key and line of TABLE.part: in no cell, as cells have no control characters

}  // namespace

TableRows::TableRows(const Table& table, std::vector<std::string> header, fs::path folder,
                     std::string fingerprint)
    : table_(table),
      header_(std::move(header)),
      folder_(std::move(folder)),
      fingerprint_(std::move(fingerprint)) {}

std::string TableRows::key(const FileValues& row) const { return row_key(table_.columns, row); }

std::string TableRows::line(const FileValues& row, const RowResult& result) const {
  std::string line;
  for (const std::string& name : header_) {
    const auto column = row.find(name), metric = result.metrics.find(name);
    if (column != row.end()) line += charts::csv_cell(cell_of(column->second));
    if (column == row.end() && metric != result.metrics.end()) line += cell_of(metric->second);
    line += ',';
  }
  return line + result.status + ',' + charts::csv_cell(result.note);
}

bool TableRows::keep() {
  if (fs::exists(part())) return keep_part();
  return !fs::exists(file()) || keep_table();
}

/// A last line without its end is of a row that was not written whole.
bool TableRows::keep_part() {
  const std::string text = read_file(part(), std::uint64_t{1} << 40);
  std::size_t begin = text.find('\n');
  if (begin == std::string::npos || text.substr(0, begin) != first_line()) return false;
  for (std::size_t end; (end = text.find('\n', ++begin)) != std::string::npos; begin = end) {
    const std::string line = text.substr(begin, end - begin);
    if (const auto at = line.find(between); at != std::string::npos)
      lines_[line.substr(0, at)] = line.substr(at + 1);
  }
  return true;
}

bool TableRows::keep_table() {
  if (!fs::exists(json()) || output::read_json(json()).value("made_from", "") != fingerprint_) return false;
  InputFile in(file());
  std::string line;
  in.line(line);
  for (const FileValues& row : table_.rows)
    if (in.line(line)) lines_[key(row)] = line;
  return true;
}

void TableRows::begin() {
  part_ = std::make_unique<OutputFile>(part(), OutputFile::Begin::empty);
  std::string text = first_line() + '\n';
  for (const auto& [key, line] : lines_) text += key + between + line + '\n';
  part_->write(text);
}

void TableRows::add(const FileValues& row, const std::string& line) {
  const std::lock_guard lock(mutex_);
  lines_[key(row)] = line;
  part_->write(key(row) + between + line + '\n');
}

void TableRows::finish() {
  std::string text;
  for (const std::string& name : header_) text += name + ',';
  text += "status,note\n";
  for (const FileValues& row : table_.rows) text += lines_.at(key(row)) + '\n';
  output::replace_text(file(), text);
}

void TableRows::remove_part() {
  part_.reset();
  fs::remove(part());
}

}  // namespace tandem::study
