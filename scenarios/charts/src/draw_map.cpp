// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "cells.hpp"
#include "drawings.hpp"
#include "frame.hpp"

namespace tandem::charts {
namespace {

/// From the smallest values on; the smaller the darker, in grey too.
constexpr std::array<const char*, 6> shades = {"#08306B", "#2A70B0", "#6BAED6",
                                               "#B5D4EA", "#E6E6E6", "#F3F3F3"};
constexpr int dark_shades = 2;
constexpr std::array<const char*, 3> sign_styles = {"with points pt 8 ps 0.55 lw 1 lc rgb '#707070'",
                                                    "with points pt 11 ps 0.55 lc rgb '#707070'",
                                                    "with points pt 6 ps 0.55 lw 1 lc rgb '#707070'"};
constexpr const char* no_value = "with points pt 2 ps 0.45 lw 1 lc rgb '#707070'";
constexpr const char* disc = "with points pt 7 ps 0.95 lc rgb 'white'";
constexpr const char* also_sign = "with points pt 6 ps 0.6 lw 1.8 lc rgb '#000000'";
constexpr const char* best_sign = "with points pt 7 ps 0.6 lc rgb '#000000'";

std::string fraction(double value) { return fmt::format("{:.2g} %", 100.0 * value); }
std::string number(double value) { return fmt::format("{:.3g}", value); }

Point place_of(const Cell& cell) { return {static_cast<double>(cell.column), static_cast<double>(cell.row)}; }

std::string tics(const std::vector<std::string>& names, bool shown) {
  std::string all;
  for (std::size_t k = 0; k < names.size(); ++k)
    all += fmt::format("{}{} {}", k == 0 ? "" : ", ", quote(shown ? names[k] : ""), k);
  return all;
}

class MapChart {
 public:
  MapChart(const Chart& chart, const Charts& charts, const Table& table)
      : chart_(chart), charts_(charts), table_(table), cells_(chart, charts, table) {}

  Picture drawn() {
    const int panels = static_cast<int>(cells_.panels().size());
    const int across = std::min(panels, chart_.across > 0 ? chart_.across : 1);
    Frame frame(chart_.name, grid(panels, across),
                {chart_.title, legends(), table_.caption(chart_, {*chart_.value})});
    for (int panel = 0; panel < panels; ++panel) {
      frame.go_to(panel / across, panel % across, cells_.panels()[static_cast<std::size_t>(panel)]);
      set_axes(frame.picture(), panel % across == 0);
      frame.picture().plot(curves(frame.picture(), static_cast<std::size_t>(panel)));
    }
    return frame.picture();
  }

  std::string words() const { return cells_.words(chart_.percent ? fraction : number); }

 private:
  Frame::Grid grid(int panels, int across) const {
    std::size_t longest = 0;
    for (const std::string& name : cells_.rows()) longest = std::max(longest, name.size());
    const int numbers = 75, left = 30 + 8 * static_cast<int>(longest);
    const int height = 20 * static_cast<int>(cells_.rows().size()) + 40 + numbers;
    const int width = across * (left + 21 * static_cast<int>(cells_.columns().size()));
    return {(panels + across - 1) / across, across, height, left, numbers, 25, std::clamp(width, 800, 1500)};
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
    const double last = chart_.limits.back();
    if (std::any_of(cells_.all().begin(), cells_.all().end(),
                    [&](const Cell& cell) { return cell.is_out(last); }))
      sign.push_back({"", no_value, "failed, refused, or above " + limit(last)});
    if (chart_.best) sign.push_back({"", best_sign, "best"});
    if (chart_.best && chart_.also) sign.push_back({"", also_sign, chart_.also->name});
    return {shade, sign};
  }

  void set_axes(Picture& picture, bool has_names) const {
    picture.command(fmt::format(
        "unset grid; unset logscale; set xrange [-0.7:{}]; set yrange [{}:-0.7]; set xtics ({}) rotate by 90 "
        "right "
        "out nomirror noenhanced; set ytics ({}) noenhanced out nomirror; set xlabel {} noenhanced offset "
        "0,0.3",
        static_cast<double>(cells_.columns().size()) - 0.3, static_cast<double>(cells_.rows().size()) - 0.3,
        tics(cells_.columns(), true), tics(cells_.rows(), has_names),
        quote(table_.label({chart_.columns, chart_.place}, charts_, false))));
  }

  std::vector<Curve> curves(Picture& picture, std::size_t panel) const {
    std::vector<std::vector<Point>> shaded(chart_.limits.size()), signs(chart_.signs.size());
    std::vector<Point> out, best, also;
    std::map<std::pair<std::string, bool>, std::vector<Point>> letters;  // whether on a dark shade
    for (const Cell& cell : cells_.all()) {
      if (cell.panel != panel) continue;
      const auto shade = std::find_if(chart_.limits.begin(), chart_.limits.end(),
                                      [&](double most) { return cell.value && *cell.value <= most; });
      if (shade != chart_.limits.end())
        shaded[static_cast<std::size_t>(shade - chart_.limits.begin())].push_back(place_of(cell));
      if (cell.sign) signs[*cell.sign].push_back(place_of(cell));
      if (!cell.letter.empty())
        letters[{cell.letter, shade < chart_.limits.begin() + dark_shades}].push_back(place_of(cell));
      if (cell.is_out(chart_.limits.back())) out.push_back(place_of(cell));
    }
    for (std::size_t column = 0; column < cells_.columns().size(); ++column)
      if (const Cell* cell = cells_.best(panel, column)) {
        best.push_back(place_of(*cell));
        const Cell* second = chart_.also ? cells_.best(panel, column, true) : nullptr;
        if (second && second != cell) also.push_back(place_of(*second));
      }
    std::vector<Curve> all;
    for (std::size_t k = 0; k < shaded.size(); ++k)
      all.push_back(
          {picture.data(shaded[k]),
           fmt::format("using 1:2:(0.5):(0.5) with boxxyerror fs solid 1 border rgb 'white' lc rgb '{}'",
                       shades[k])});
    for (std::size_t k = 0; k < signs.size(); ++k) all.push_back({picture.data(signs[k]), sign_styles[k]});
    all.push_back({picture.data(out), no_value});
    for (const auto& [letter, points] : letters)
      all.push_back(
          {picture.data(points), fmt::format("with points pt {} ps 1 lc rgb '{}'", quote(letter.first),
                                             letter.second ? "white" : "#000000")});
    const std::string marked = picture.data(best), marked_too = picture.data(also);
    all.push_back({marked, disc}), all.push_back({marked, best_sign});
    all.push_back({marked_too, disc}), all.push_back({marked_too, also_sign});
    return all;
  }

  const Chart& chart_;
  const Charts& charts_;
  const Table& table_;
  Cells cells_;
};

}  // namespace

Picture draw_map(const Chart& chart, const Charts& charts, const Table& table, std::string& words) {
  MapChart map(chart, charts, table);
  if (chart.best) words += map.words();
  return map.drawn();
}

}  // namespace tandem::charts
