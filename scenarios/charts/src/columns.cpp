// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/chart.hpp"
#include "tandem/text/expression.hpp"

namespace tandem::charts {
namespace {

void add(const std::optional<Quantity>& quantity, std::vector<Quantity>& to) {
  if (!quantity) return;
  for (const std::string& name : text::names_in(quantity->text)) to.push_back({name, quantity->place});
}

}  // namespace

std::vector<Quantity> columns_of(const Chart& chart) {
  std::vector<Quantity> all;
  for (const auto& one : {chart.where, chart.hollow, chart.value}) add(one, all);
  for (const Quantity& x : chart.x) add(x, all);
  for (const auto& panel : chart.y)
    for (const Quantity& y : panel) {
      add(y, all);
      if (!chart.difference.empty()) all.push_back({y.text + "." + chart.difference, y.place});
    }
  for (const Sign& sign : chart.signs) add(sign.when, all);
  if (chart.also) add(chart.also->when, all);
  for (const auto* columns : {&chart.panels, &chart.colour, &chart.marker, &chart.rows, &chart.series})
    for (const std::string& column : *columns) all.push_back({column, chart.place});
  for (const std::string& column : {chart.columns, chart.jumps, chart.text})
    if (!column.empty()) all.push_back({column, chart.place});
  return all;
}

}  // namespace tandem::charts
