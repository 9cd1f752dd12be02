// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "drawings.hpp"
#include "groups.hpp"

namespace tandem::charts {
namespace {

/// Whole numbers as they are, others with so many digits that count.
std::string shown(double value, int digits) {
  constexpr double most = 1e15, large = 1e6, small = 1e-4;
  const double size = std::abs(value);
  if (value == std::round(value) && size < most) return fmt::format("{:.0f}", value);
  if (size < small || size >= large) return fmt::format("{:.{}e}", value, digits - 1);
  const int before = static_cast<int>(std::floor(std::log10(size))) + 1;  // digits before the point
  return fmt::format("{:.{}f}", value, std::max(0, digits - before));
}

class MarkdownTable {
 public:
  MarkdownTable(const Chart& chart, const Charts& charts, const Table& table)
      : chart_(chart), charts_(charts), table_(table) {
    for (const std::size_t row : table.chosen(chart.where)) place(row);
  }

  std::string text() const {
    std::string text = line(head()), rule = "|";
    for (std::size_t k = 0; k < head().size(); ++k) rule += "---|";
    text += rule + '\n';
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      std::vector<std::string> cells = words_[row];
      for (std::size_t column = 0; column < width(); ++column) {
        const auto it = cells_.find({row, column});
        cells.push_back(it == cells_.end() ? "" : it->second);
      }
      text += line(cells);
    }
    return text;
  }

 private:
  static std::string line(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += ' ' + cell + (cell.empty() ? "|" : " |");
    return text + '\n';
  }

  std::size_t width() const { return chart_.columns.empty() ? chart_.y.size() : columns_.size(); }

  std::vector<std::string> head() const {
    std::vector<std::string> head;
    for (const std::string& column : chart_.rows) head.push_back(charts_.name_of(column));
    if (!chart_.columns.empty())
      for (const std::string& name : columns_.names())
        head.push_back(head.size() == chart_.rows.size() ? charts_.name_of(chart_.columns) + ": " + name
                                                         : name);
    if (chart_.columns.empty())
      for (const auto& cell : chart_.y) head.push_back(table_.label(cell[0], charts_, false));
    return head;
  }

  void place(std::size_t row) {
    const std::size_t at = rows_.of(table_.words(row, chart_.rows, chart_.place, charts_));
    if (at == words_.size()) {
      words_.emplace_back();
      for (const std::string& column : chart_.rows)
        words_[at].push_back(table_.cell(row, column, chart_.place, charts_));
    }
    if (chart_.columns.empty()) {
      for (std::size_t k = 0; k < chart_.y.size(); ++k) cells_[{at, k}] = cell(row, {chart_.y[k]});
      return;
    }
    const std::size_t column = columns_.of(table_.cell(row, chart_.columns, chart_.place, charts_));
    cells_[{at, column}] = cell(row, chart_.y);
  }

  /// The first value, the others in brackets; of a row that failed its status.
  std::string cell(std::size_t row, const std::vector<std::vector<Quantity>>& parts) const {
    std::string first, others;
    for (const auto& part : parts)
      for (const Quantity& quantity : part) {
        const auto value = table_.number(row, quantity);
        const std::string one = value ? shown(*value, chart_.digits) : "";
        if (first.empty())
          first = one;
        else if (!one.empty())
          others += (others.empty() ? "" : "; ") + one;
      }
    const std::string text = others.empty() ? first : first + " (" + others + ")";
    return table_.failed(row) ? table_.cell(row, "status", chart_.place, charts_) : text;
  }

  const Chart& chart_;
  const Charts& charts_;
  const Table& table_;
  Groups rows_, columns_;
  std::vector<std::vector<std::string>> words_;  ///< by row
  std::map<std::pair<std::size_t, std::size_t>, std::string> cells_;
};

}  // namespace

std::string markdown_table(const Chart& chart, const Charts& charts, const Table& table) {
  return MarkdownTable(chart, charts, table).text();
}

}  // namespace tandem::charts
