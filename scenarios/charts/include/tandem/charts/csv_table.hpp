// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tandem::charts {

/// A cell of a CSV file: in quotes where it has a comma, a quote or an end of line (RFC 4180).
std::string csv_cell(const std::string& text);

/// A CSV file in memory: one header row, then rows with as many cells. A cell in double quotes may hold
/// commas, and "" for a quote; no cell spans lines.
class CsvTable {
 public:
  /// One row; it lives as long as its table. All of these throw Error naming file, line and column, but
  /// nothing that stands there: the file may be none of ours.
  class Row {
   public:
    const std::string& text(std::string_view column) const;
    /// Letters, digits and _ only: what the name of a picture may be made of.
    const std::string& name(std::string_view column) const;
    /// NaN where the cell is empty.
    double number(std::string_view column) const;
    /// Finite and above 0: what a logarithmic axis can show.
    double positive(std::string_view column) const;

   private:
    friend class CsvTable;
    Row(const CsvTable& table, std::size_t index) : table_(table), index_(index) {}
    [[noreturn]] void refuse(std::string_view column, const std::string& allowed) const;
    const CsvTable& table_;
    std::size_t index_;
  };

  /// Throws Error naming file and line if the file can't be read, lacks one of the columns, or a row has
  /// another number of cells than the header.
  static CsvTable read(const std::filesystem::path& file, const std::vector<std::string>& columns);

  std::size_t size() const { return rows_.size(); }
  /// In the order of the header.
  const std::vector<std::string>& names() const { return names_; }
  bool has(std::string_view column) const { return columns_.contains(column); }
  Row operator[](std::size_t index) const { return Row(*this, index); }
  const std::filesystem::path& file() const { return file_; }

 private:
  explicit CsvTable(std::filesystem::path file) : file_(std::move(file)) {}
  std::vector<std::string> cells_of(const std::string& line, std::size_t number) const;
  void take_header(const std::string& line, const std::vector<std::string>& required);
  void take_row(const std::string& line);
  [[noreturn]] void refuse(std::size_t line, const std::string& why) const;

  std::filesystem::path file_;
  std::vector<std::string> names_;
  std::map<std::string, std::size_t, std::less<>> columns_;
  std::vector<std::vector<std::string>> rows_;  // row k stands in line k + 2
};

}  // namespace tandem::charts
