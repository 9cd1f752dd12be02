// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace tandem::charts {

Cells::Cells(const Chart& chart, const Charts& charts, const Table& table) : chart_(chart) {
  const auto rows = table.chosen(chart.where);
  const Quantity column{chart.columns, chart.place};
  const bool has_words = table.is_word(column);
  Groups columns;
  std::vector<double> numbers;
  for (const std::size_t row : rows) {
    const double number = has_words ? 0.0 : table.number(row, column).value_or(0.0);
    add(row, charts, table);
    cells_.back().column = columns.of(has_words ? table.words(row, {chart.columns}, chart.place, charts)
                                                : fmt::format("{}", number));
    numbers.resize(columns.size(), has_words ? static_cast<double>(columns.size()) : number);
  }
  std::vector<std::size_t> order(columns.size()), place(columns.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return numbers[a] < numbers[b]; });
  for (std::size_t k = 0; k < order.size(); ++k)
    place[order[k]] = k, columns_.push_back(columns.names()[order[k]]);
  for (Cell& cell : cells_) cell.column = place[cell.column];
}

/// All but its column.
void Cells::add(std::size_t row, const Charts& charts, const Table& table) {
  Cell cell{panels_.of(table.words(row, chart_.panels, chart_.place, charts)),
            rows_.of(table.words(row, chart_.rows, chart_.place, charts)),
            0,
            {},
            {},
            false,
            {}};
  if (!table.failed(row)) cell.value = table.number(row, *chart_.value);
  for (std::size_t k = 0; k < chart_.signs.size() && cell.value && !cell.sign; ++k)
    if (table.number(row, chart_.signs[k].when).value_or(0.0) != 0.0) cell.sign = k;
  cell.also = chart_.also && table.number(row, chart_.also->when).value_or(0.0) != 0.0;
  if (!chart_.text.empty()) cell.letter = table.cell(row, chart_.text, chart_.place, charts).substr(0, 1);
  cells_.push_back(cell);
}

const Cell* Cells::best(std::size_t panel, std::size_t column, bool also) const {
  const Cell* best = nullptr;
  for (const Cell& cell : cells_)
    if (cell.panel == panel && cell.column == column && (!also || cell.also) && cell.value && chart_.best &&
        *cell.value <= *chart_.best && (!best || *cell.value < *best->value))
      best = &cell;
  return best;
}

std::string Cells::words(std::string (*value)(double)) const {
  std::string all;
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    all += panels_.names()[panel].empty() ? "" : panels_.names()[panel] + "\n";
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      const Cell* best = this->best(panel, column);
      all += fmt::format("{:>10}  {}\n", columns_[column],
                         best ? rows_.names()[best->row] + " (" + value(*best->value) + ")" : "none");
    }
  }
  return all;
}

}  // namespace tandem::charts
