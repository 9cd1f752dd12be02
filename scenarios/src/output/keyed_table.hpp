// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tandem::output {

/// Empty for no value.
std::string cell(const std::optional<double>& value);

/// The rows of a CSV file by their first cells, so that a long work that was stopped can go on. Cells hold no
/// commas. The cells under schedule, to_fast, to_slow and note are texts, those under status are ok or
/// failed, all others numbers or empty.
class KeyedTable {
 public:
  /// header: the names of the columns, with commas between; the first `key_cells` of them are the key.
  KeyedTable(std::string header, int key_cells) : header_(std::move(header)), key_cells_(key_cells) {}

  /// Reads a file that was written before. Throws Error(input_output) naming file and line for what is no
  /// such table.
  void read(const std::filesystem::path& file);
  /// Replaces the file by the rows of these keys, in this order, as far as they are there.
  void write(const std::filesystem::path& file, const std::vector<std::string>& keys) const;

  const std::string& header() const { return header_; }
  bool has(const std::string& key) const { return rows_.count(key) != 0; }
  /// cells: those after the key, with commas between.
  void set(const std::string& key, const std::string& cells) { rows_[key] = cells; }
  std::size_t size() const { return rows_.size(); }

 private:
  std::string header_;
  int key_cells_;
  std::map<std::string, std::string> rows_;
};

}  // namespace tandem::output
