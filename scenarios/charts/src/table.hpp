// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tandem/charts/chart.hpp"
#include "tandem/charts/csv_table.hpp"
#include "tandem/text/expression.hpp"

namespace tandem::charts {

/// A table of results in memory: TABLE.csv, with what TABLE.json says of it.
class Table {
 public:
  /// name: what charts call it. Throws Error that names the file, and the line of what is wrong in it.
  Table(const std::filesystem::path& folder, const std::string& name);

  std::string file() const { return csv_.file().filename().string(); }
  std::size_t rows() const { return csv_.size(); }
  bool has(const std::string& column) const;
  /// Whether it is a column with something that is no number.
  bool is_word(const Quantity& quantity) const;
  /// "name [unit]" of what is drawn: for a metric the unit that the table has.
  std::string label(const Quantity& quantity, const Charts& charts, bool percent) const;
  /// The lines below a chart of these quantities: its notes, their norms, the program and the machine.
  std::vector<std::string> caption(const Chart& chart, const std::vector<Quantity>& shown) const;

  /// Nothing where a column that it needs is empty, or not finite. Throws Error naming the place for a
  /// column that is not there, and for a word where a number is needed.
  std::optional<double> number(std::size_t row, const Quantity& quantity) const;
  /// What stands there.
  const std::string& text(std::size_t row, const std::string& column) const { return csv_[row].text(column); }
  /// Whether the row has a status other than ok.
  bool failed(std::size_t row) const;
  /// The rows for which `where` holds; all without one.
  std::vector<std::size_t> chosen(const std::optional<Quantity>& where) const;
  /// What these columns have in a row, as the charts call it, with commas between. Throws likewise.
  std::string words(std::size_t row, const std::vector<std::string>& columns, const text::Place& place,
                    const Charts& charts) const;
  /// What a column has in a row, as the charts call it. Throws likewise.
  const std::string& cell(std::size_t row, const std::string& column, const text::Place& place,
                          const Charts& charts) const;

 private:
  void check(const std::string& column, const text::Place& place) const;

  CsvTable csv_;
  std::map<std::string, std::string> units_, norms_;
  std::string made_;
};

}  // namespace tandem::charts
