// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "drawings.hpp"
#include "groups.hpp"

namespace tandem::charts {
namespace {

/// With so many digits that count; whole numbers as they are.
std::string rounded(double value, int digits) {
  constexpr double most = 1e15, large = 1e6, small = 1e-4;
  const double size = std::abs(value);
  if (value == std::round(value) && size < most) return fmt::format("{:.0f}", value);
  if (size < small || size >= large) return fmt::format("{:.{}e}", value, digits - 1);
  const int before = static_cast<int>(std::floor(std::log10(size))) + 1;  // digits before the point
  return fmt::format("{:.{}f}", value, std::max(0, digits - before));
}

/// Whether a number that is written with a point has no more digits than that.
bool is_short(const std::string& number, int digits) {
  const auto first = number.find_first_not_of("-0.");
  return first != std::string::npos && number.find('.') != std::string::npos &&
         number.find_first_not_of("-.0123456789") == std::string::npos &&
         std::count_if(number.begin() + first, number.end(), [](char c) { return c != '.'; }) <= digits;
}

/// What the values of several rows make, of which there is one at least.
double together(const std::string& each, const std::vector<double>& values) {
  if (each == "least") return *std::min_element(values.begin(), values.end());
  if (each == "most") return *std::max_element(values.begin(), values.end());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return each == "mean" ? sum / static_cast<double>(values.size()) : sum;
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
    for (std::size_t at = 0; at < rows_.size(); ++at) {
      std::vector<std::string> cells = words_[at];
      const std::size_t parts = chart_.y.size();
      if (chart_.columns.empty())
        for (std::size_t k = 0; k < parts; ++k) cells.push_back(cell(cells_.at({at, 0}), k, k + 1));
      else
        for (std::size_t column = 0; column < columns_.size(); ++column) {
          const auto it = cells_.find({at, column});
          cells.push_back(it == cells_.end() ? "" : cell(it->second, 0, parts));
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
    const std::string name =
        chart_.columns.empty() ? "" : table_.cell(row, chart_.columns, chart_.place, charts_);
    auto& rows = cells_[{at, columns_.of(name)}];
    rows.push_back(row);
    if (rows.size() > 1 && chart_.each.empty())
      refuse(chart_.place,
             fmt::format("table '{}': rows {} and {} of {} stand in one cell; `each` says what they "
                         "make, or `where` leaves one out",
                         chart_.name, rows[0] + 1, row + 1, table_.file()));
  }

  /// The first value, the others in brackets, of some of what stands in a cell; of one row that failed its status.
  std::string cell(const std::vector<std::size_t>& rows, std::size_t from, std::size_t to) const {
    if (chart_.each.empty() && table_.failed(rows[0]))
      return table_.cell(rows[0], "status", chart_.place, charts_);
    std::string first, others;
    for (std::size_t part = from; part < to; ++part)
      for (const Quantity& quantity : chart_.y[part]) {
        const std::string one = chart_.each.empty()
                                    ? shown(rows[0], quantity)
                                    : shown(rows, quantity, chart_.each[part % chart_.each.size()]);
        if (first.empty())
          first = one;
        else if (!one.empty())
          others += (others.empty() ? "" : "; ") + one;
      }
    return others.empty() ? first : first + " (" + others + ")";
  }

  /// A number with the chart's digits, or as it stands in the table if it has fewer there; a word as it is called.
  std::string shown(std::size_t row, const Quantity& quantity) const {
    const std::string own = table_.has(quantity.text) ? table_.text(row, quantity.text) : "";
    if (table_.is_word(quantity)) return charts_.name_of(own);
    const auto value = table_.number(row, quantity);
    if (!value) return {};
    return is_short(own, chart_.digits) ? own : rounded(*value, chart_.digits);
  }

  std::string shown(const std::vector<std::size_t>& rows, const Quantity& quantity,
                    const std::string& each) const {
    std::vector<double> values;
    for (const std::size_t row : rows)
      if (const auto value = table_.number(row, quantity); value && !table_.failed(row))
        values.push_back(*value);
    return values.empty() ? "" : rounded(together(each, values), chart_.digits);
  }

  const Chart& chart_;
  const Charts& charts_;
  const Table& table_;
  Groups rows_, columns_;
  std::vector<std::vector<std::string>> words_;                                    ///< by row
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> cells_;  ///< rows of the table
};

}  // namespace

std::string markdown_table(const Chart& chart, const Charts& charts, const Table& table) {
  return MarkdownTable(chart, charts, table).text();
}

}  // namespace tandem::charts
