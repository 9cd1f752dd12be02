// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "strips.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "looks.hpp"

namespace tandem::charts {
namespace {

/// "fast.x1.exact" beside "fast.x1".
bool is_reference(const Quantity& one, const std::vector<Quantity>& all) {
  return std::any_of(all.begin(), all.end(),
                     [&](const Quantity& other) { return one.text.starts_with(other.text + "."); });
}

}  // namespace

Strips::Strips(const Chart& chart, const Charts& charts, const Table& table)
    : chart_(chart), charts_(charts), table_(table) {
  const auto rows = table.chosen(chart.where);
  Groups panels;
  std::vector<std::vector<std::size_t>> of_panel;
  for (const std::size_t row : rows) {
    const std::size_t panel = panels.of(table.words(row, chart.panels, chart.place, charts));
    of_panel.resize(panels.size());
    of_panel[panel].push_back(row);
  }
  for (std::size_t panel = 0; panel < panels.size(); ++panel)
    for (std::size_t k = 0; k < chart.y.size(); ++k) add(panels.names()[panel], of_panel[panel], k);
  if (!chart.jumps.empty()) find_jumps(rows);
}

/// That of the only quantity that is no reference.
std::string Strips::label_of(const std::vector<Quantity>& y) const {
  std::vector<Quantity> own;
  std::copy_if(y.begin(), y.end(), std::back_inserter(own),
               [&](const Quantity& one) { return !is_reference(one, y); });
  return own.size() == 1 ? table_.label(own[0], charts_, false) : "";
}

std::size_t Strips::look_of(std::size_t row, const std::vector<Quantity>& y, const Quantity& one) {
  if (is_reference(one, y)) return references_.of(table_.label(one, charts_, false));
  std::string word = table_.words(row, chart_.series, chart_.place, charts_);
  if (std::count_if(y.begin(), y.end(), [&](const Quantity& other) { return !is_reference(other, y); }) > 1)
    word += (word.empty() ? "" : ", ") + table_.label(one, charts_, false);
  return word.empty() ? 0 : looks_.of(word);  // alone in its panel
}

void Strips::add(const std::string& panel, const std::vector<std::size_t>& rows, std::size_t which) {
  const auto& y = chart_.y[which];
  Strip strip{panel, label_of(y), 2 * which, {}}, difference = strip;
  ++difference.kind;
  for (const Quantity& one : y) {
    add_traces(strip, rows, one, y, {});
    if (!chart_.difference.empty())
      add_traces(difference, rows, one, y, Quantity{one.text + "." + chart_.difference, one.place});
  }
  strips_.push_back(std::move(strip));
  if (chart_.difference.empty()) return;
  difference.title += (panel.empty() ? "" : ": ") + ("difference from " + charts_.name_of(chart_.difference));
  strips_.push_back(std::move(difference));
}

/// less: it is drawn without this.
void Strips::add_traces(Strip& to, const std::vector<std::size_t>& rows, const Quantity& y,
                        const std::vector<Quantity>& all, const std::optional<Quantity>& less) {
  std::map<std::size_t, std::vector<Point>> points;  // by look
  for (const std::size_t row : rows) {
    const auto x = table_.number(row, chart_.x.front()), value = table_.number(row, y);
    const auto reference = less ? table_.number(row, *less) : std::optional(0.0);
    if (!x) continue;
    auto& own = points[look_of(row, all, y)];
    if (!own.empty() && *x < own.back().x) own.push_back({*x, undefined});  // another run begins
    own.push_back({*x, value && reference ? *value - *reference : undefined});
  }
  for (auto& [look, own] : points) to.traces.push_back({look, is_reference(y, all), std::move(own)});
}

void Strips::find_jumps(const std::vector<std::size_t>& rows) {
  std::string before;
  double last = std::numeric_limits<double>::infinity();
  for (const std::size_t row : rows) {
    const std::string word = table_.words(row, {chart_.jumps}, chart_.place, charts_);
    const auto x = table_.number(row, chart_.x.front());
    if (word != before && x && *x >= last) jumps_.push_back(*x);
    before = word, last = x.value_or(last);
  }
  std::sort(jumps_.begin(), jumps_.end());
  jumps_.erase(std::unique(jumps_.begin(), jumps_.end()), jumps_.end());
}

}  // namespace tandem::charts
