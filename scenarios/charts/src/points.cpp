// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "points.hpp"

#include <cmath>

namespace tandem::charts {

Points::Points(const Chart& chart, const Charts& charts, const Table& table)
    : chart_(chart), charts_(charts), table_(table), rows_(table.chosen(chart.where)) {
  for (const std::size_t row : rows_) {
    panels_.of(table.words(row, chart.panels, chart.place, charts));
    markers_.of(table.words(row, chart.marker, chart.place, charts));
    for (const auto& y : chart.y)
      for (const Quantity& one : y) colour_of(row, y, one);
    if (table.is_word(chart.x.front()))
      words_.of(table.words(row, {chart.x.front().text}, chart.place, charts));
  }
}

/// Several quantities in one panel differ by their colours.
std::size_t Points::colour_of(std::size_t row, const std::vector<Quantity>& y, const Quantity& one) const {
  std::string word = table_.words(row, chart_.colour, chart_.place, charts_);
  if (y.size() > 1) word += (word.empty() ? "" : ", ") + table_.label(one, charts_, false);
  return colours_.of(word);
}

std::optional<double> Points::x_of(const Table& table, std::size_t row, const Quantity& x) const {
  if (words_.size() == 0) return table.number(row, x);
  return static_cast<double>(words_.of(table.words(row, {x.text}, chart_.place, charts_)));
}

std::vector<Mark> Points::marks(std::size_t panel_row) const {
  const double factor = chart_.percent ? 100.0 : 1.0;
  std::vector<Mark> marks;
  for (const std::size_t row : rows_)
    for (const Quantity& y : chart_.y[panel_row]) {
      Mark mark;
      mark.panel = panels_.of(table_.words(row, chart_.panels, chart_.place, charts_));
      mark.look = {colour_of(row, chart_.y[panel_row], y),
                   markers_.of(table_.words(row, chart_.marker, chart_.place, charts_))};
      if (chart_.kind == Chart::Kind::curves) mark.look.shape = mark.look.colour;
      mark.x = x_of(table_, row, chart_.x[panel_row]);
      const auto value = table_.number(row, y);
      const bool beyond = chart_.limit && value && std::abs(*value) > *chart_.limit;
      const bool has_place = value && !(chart_.log_y && *value < 0.0);
      if (has_place && !beyond && !table_.failed(row)) mark.y = factor * *value;
      mark.hollow = chart_.hollow && table_.number(row, *chart_.hollow).value_or(1.0) != 0.0;
      marks.push_back(mark);
    }
  return marks;
}

std::vector<Mark> Points::overlaid(std::size_t panel_row, const Table& other) const {
  std::vector<std::string> common;
  for (const std::string& column : chart_.panels)
    if (other.has(column)) common.push_back(column);
  std::vector<Mark> marks;
  for (const std::size_t row : other.chosen(chart_.overlay->where))
    for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
      if (!common.empty() && other.words(row, common, chart_.place, charts_) != panels_.names()[panel])
        continue;
      const auto y = other.number(row, chart_.y[panel_row].front());
      marks.push_back({panel, {}, x_of(other, row, chart_.x[panel_row]), y});
      if (y && chart_.percent) marks.back().y = 100.0 * *y;
    }
  return marks;
}

std::vector<std::optional<double>> Points::floors(std::size_t panel_row) const {
  std::vector<std::optional<double>> floors(panels_.size());
  const Quantity& y = chart_.y[panel_row].front();
  const Quantity floor = chart_.floor.value_or(Quantity{y.text + ".floor", y.place});
  if (!chart_.floor && !table_.has(floor.text)) return floors;
  for (const std::size_t row : rows_)
    if (const auto value = table_.number(row, floor)) {
      auto& most = floors[panels_.of(table_.words(row, chart_.panels, chart_.place, charts_))];
      most = std::max(most.value_or(0.0), (chart_.percent ? 100.0 : 1.0) * *value);
    }
  return floors;
}

}  // namespace tandem::charts
