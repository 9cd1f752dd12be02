// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "groups.hpp"
#include "table.hpp"

namespace tandem::charts {

struct Cell {
  std::size_t panel, row, column;
  std::optional<double> value;      ///< nothing where it is no result
  std::optional<std::size_t> sign;  ///< the first that holds
  bool also;                        ///< the chart's `also` holds
  std::string letter;               ///< what stands in it, besides; empty: nothing

  /// Neither shaded nor signed.
  bool is_out(double limit) const { return !sign && (!value || *value > limit); }
};

/// The cells of a map. Columns with numbers rise; all else is in the order of the table.
class Cells {
 public:
  Cells(const Chart& chart, const Charts& charts, const Table& table);

  const std::vector<Cell>& all() const { return cells_; }
  const std::vector<std::string>& panels() const { return panels_.names(); }
  const std::vector<std::string>& rows() const { return rows_.names(); }
  const std::vector<std::string>& columns() const { return columns_; }
  /// The one with the smallest value of a column, unless it is larger than the chart's `best`; null: none.
  /// also: of those for which that holds.
  const Cell* best(std::size_t panel, std::size_t column, bool also = false) const;
  /// Which is best of each column, a line each. value: how a value is shown.
  std::string words(std::string (*value)(double)) const;

 private:
  void add(std::size_t row, const Charts& charts, const Table& table);

  const Chart& chart_;
  Groups panels_, rows_;
  std::vector<std::string> columns_;
  std::vector<Cell> cells_;
};

}  // namespace tandem::charts
