// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "drawings.hpp"
#include "frame.hpp"
#include "groups.hpp"

namespace tandem::charts {
namespace {

/// From the smallest values on; the smaller the darker, in grey too.
constexpr std::array<const char*, 6> shades = {"#08306B", "#2A70B0", "#6BAED6",
                                               "#B5D4EA", "#E6E6E6", "#F3F3F3"};
constexpr std::array<const char*, 3> sign_styles = {"with points pt 8 ps 0.55 lw 1 lc rgb '#707070'",
                                                    "with points pt 11 ps 0.55 lc rgb '#707070'",
                                                    "with points pt 6 ps 0.55 lw 1 lc rgb '#707070'"};
constexpr const char* no_value = "with points pt 2 ps 0.45 lw 1 lc rgb '#707070'";
constexpr const char* disc = "with points pt 7 ps 0.95 lc rgb 'white'";
constexpr const char* best_sign = "with points pt 7 ps 0.6 lc rgb '#000000'";

struct Cell {
  std::size_t panel, row, column;
  std::optional<double> value;  ///< nothing where it is no result
  std::size_t sign;             ///< the first that holds; sign_styles.size(): none
};

class MapChart {
 public:
  MapChart(const Chart& chart, const Charts& charts, const Table& table)
      : chart_(chart), charts_(charts), table_(table) {
    for (const std::size_t row : table.chosen(chart.where)) add(row);
    for (std::size_t k = 0; k < columns_.size(); ++k) order_.push_back(k);
    if (!table.is_word({chart.columns, chart.place}))
      std::sort(order_.begin(), order_.end(),
                [&](std::size_t a, std::size_t b) { return column_values_[a] < column_values_[b]; });
    place_.resize(order_.size());
    for (std::size_t k = 0; k < order_.size(); ++k) place_[order_[k]] = static_cast<double>(k);
  }

  Picture drawn() {
    std::size_t longest = 0;
    for (const std::string& name : rows_.names()) longest = std::max(longest, name.size());
    const int panels = static_cast<int>(panels_.size());
    const int across = std::min(panels, chart_.across > 0 ? chart_.across : 1);
    const int numbers = 75, height = 20 * static_cast<int>(rows_.size()) + 40 + numbers;
    const int left = 30 + 7 * static_cast<int>(longest);
    std::vector<std::string> caption = chart_.notes;
    for (std::string& line : table_.made({*chart_.value})) caption.push_back(std::move(line));
    Frame frame(chart_.name, {(panels + across - 1) / across, across, height, left, numbers, 25},
                {chart_.title, legends(), caption});
    for (int panel = 0; panel < panels; ++panel) {
      frame.go_to(panel / across, panel % across, panels_.names()[static_cast<std::size_t>(panel)]);
      set_axes(frame.picture(), panel % across == 0);
      frame.picture().plot(curves(frame.picture(), static_cast<std::size_t>(panel)));
    }
    return frame.picture();
  }

  /// "1.5: fastest-first, lagrange2 (0.1 %)", a line for each column.
  std::string words() const {
    std::string all;
    for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
      all += panels_.names()[panel].empty() ? "" : panels_.names()[panel] + "\n";
      for (const std::size_t column : order_) {
        const Cell* best = best_of(panel, column);
        all += fmt::format("{:>10}  {}\n", columns_.names()[column],
                           best ? rows_.names()[best->row] + " (" + shown(*best->value) + ")" : "none");
      }
    }
    return all;
  }

 private:
  void add(std::size_t row) {
    Cell cell{panels_.of(table_.words(row, chart_.panels, chart_.place, charts_)),
              rows_.of(table_.words(row, chart_.rows, chart_.place, charts_)),
              0,
              {},
              0};
    const Quantity column{chart_.columns, chart_.place};
    if (table_.is_word(column)) {
      cell.column = columns_.of(table_.words(row, {chart_.columns}, chart_.place, charts_));
    } else {
      const double value = table_.number(row, column).value_or(0.0);
      cell.column = columns_.of(fmt::format("{}", value));
      column_values_.resize(columns_.size(), value);
    }
    if (!table_.failed(row)) cell.value = table_.number(row, *chart_.value);
    while (cell.sign < chart_.signs.size() &&
           table_.number(row, chart_.signs[cell.sign].when).value_or(0.0) == 0.0)
      ++cell.sign;
    if (cell.sign == chart_.signs.size() || !cell.value) cell.sign = sign_styles.size();
    cells_.push_back(cell);
  }

  std::string shown(double value) const {
    return chart_.percent ? fmt::format("{:.2g} %", 100.0 * value) : fmt::format("{:.3g}", value);
  }
  std::string limit(double value) const {
    return chart_.percent ? fmt::format("{:g} %", 100.0 * value) : fmt::format("{:g}", value);
  }

  std::vector<std::vector<Curve>> legends() const {
    std::vector<Curve> shade, sign;
    for (std::size_t k = 0; k < chart_.limits.size(); ++k)
      shade.push_back({"", fmt::format("with points pt 5 ps 1.4 lc rgb '{}'", shades[k]),
                       "up to " + limit(chart_.limits[k])});
    for (std::size_t k = 0; k < chart_.signs.size(); ++k)
      sign.push_back({"", sign_styles[k], chart_.signs[k].name});
    if (std::any_of(cells_.begin(), cells_.end(), [&](const Cell& cell) { return is_out(cell); }))
      sign.push_back({"", no_value, "failed, or above " + limit(chart_.limits.back())});
    if (chart_.best) sign.push_back({"", best_sign, "best"});
    return {shade, sign};
  }

  bool is_out(const Cell& cell) const {
    return cell.sign == sign_styles.size() && (!cell.value || *cell.value > chart_.limits.back());
  }

  void set_axes(Picture& picture, bool numbers) const {
    std::string columns, rows;
    for (std::size_t k = 0; k < order_.size(); ++k)
      columns += fmt::format("{}{} {}", k == 0 ? "" : ", ", quote(columns_.names()[order_[k]]), k);
    for (std::size_t k = 0; k < rows_.size(); ++k)
      rows += fmt::format("{}{} {}", k == 0 ? "" : ", ", quote(numbers ? rows_.names()[k] : ""), k);
    picture.command(fmt::format(
        "unset grid; unset logscale; set xrange [-0.7:{}]; set yrange [{}:-0.7]; set xtics ({}) rotate by 90 "
        "right out "
        "nomirror noenhanced; set ytics ({}) noenhanced out nomirror; set xlabel {} noenhanced offset 0,0.3",
        static_cast<double>(order_.size()) - 0.3, static_cast<double>(rows_.size()) - 0.3, columns, rows,
        quote(table_.label({chart_.columns, chart_.place}, charts_, false))));
  }

  Point place_of(const Cell& cell) const { return {place_[cell.column], static_cast<double>(cell.row)}; }

  const Cell* best_of(std::size_t panel, std::size_t column) const {
    const Cell* best = nullptr;
    for (const Cell& cell : cells_)
      if (cell.panel == panel && cell.column == column && cell.value &&
          *cell.value <= chart_.best.value_or(0.0) && (!best || *cell.value < *best->value))
        best = &cell;
    return best;
  }

  std::vector<Curve> curves(Picture& picture, std::size_t panel) const {
    std::vector<std::vector<Point>> shaded(chart_.limits.size()), signs(sign_styles.size());
    std::vector<Point> out, best;
    for (const Cell& cell : cells_) {
      if (cell.panel != panel) continue;
      const auto limit = std::find_if(chart_.limits.begin(), chart_.limits.end(),
                                      [&](double most) { return cell.value && *cell.value <= most; });
      if (limit != chart_.limits.end())
        shaded[static_cast<std::size_t>(limit - chart_.limits.begin())].push_back(place_of(cell));
      if (cell.sign < sign_styles.size()) signs[cell.sign].push_back(place_of(cell));
      if (is_out(cell)) out.push_back(place_of(cell));
    }
    for (std::size_t column = 0; column < columns_.size(); ++column)
      if (const Cell* cell = best_of(panel, column)) best.push_back(place_of(*cell));
    std::vector<Curve> all;
    for (std::size_t k = 0; k < shaded.size(); ++k)
      all.push_back(
          {picture.data(shaded[k]),
           fmt::format("using 1:2:(0.5):(0.5) with boxxyerror fs solid 1 border rgb 'white' lc rgb '{}'",
                       shades[k])});
    for (std::size_t k = 0; k < chart_.signs.size(); ++k)
      all.push_back({picture.data(signs[k]), sign_styles[k]});
    all.push_back({picture.data(out), no_value});
    const std::string marked = picture.data(best);
    all.push_back({marked, disc}), all.push_back({marked, best_sign});
    return all;
  }

  const Chart& chart_;
  const Charts& charts_;
  const Table& table_;
  Groups panels_, rows_, columns_;
  std::vector<double> column_values_;
  std::vector<std::size_t> order_;  ///< of columns, by their values
  std::vector<double> place_;       ///< by column
  std::vector<Cell> cells_;
};

}  // namespace

Picture draw_map(const Chart& chart, const Charts& charts, const Table& table, std::string& words) {
  MapChart map(chart, charts, table);
  if (chart.best) words += map.words();
  return map.drawn();
}

}  // namespace tandem::charts
