// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "drawings.hpp"
#include "frame.hpp"
#include "points.hpp"
#include "tandem/charts/pareto.hpp"
#include "tandem/charts/style.hpp"

namespace tandem::charts {
namespace {

constexpr const char* front_line = "with steps lc rgb '#000000' lw 1";
constexpr const char* front_ring = "with points pt 6 ps 1.3 lw 1 lc rgb '#000000'";
constexpr const char* overlay_points = "with points pt 3 ps 1 lw 1.5 lc rgb '#D55E00'";
constexpr std::size_t most_strip_rows = 5;

/// Draws curves and work charts.
class PointsChart {
 public:
  PointsChart(const Chart& chart, const Charts& charts, const Table& table, const Table* overlay)
      : chart_(chart), charts_(charts), table_(table), overlay_(overlay), points_(chart, charts, table) {}

  Picture drawn() {
    for (std::size_t row = 0; row < chart_.y.size(); ++row) marks_.push_back(points_.marks(row));
    Frame frame(chart_.name, grid(), {chart_.title, legends(), caption()});
    for (std::size_t row = 0; row < chart_.y.size(); ++row) draw_row(frame, row);
    return frame.picture();
  }

 private:
  int across() const {
    const int count = static_cast<int>(points_.panels().size());
    return std::min(count, chart_.across > 0 ? chart_.across : 4);
  }
  int lines_of_panels() const {
    return (static_cast<int>(points_.panels().size()) + across() - 1) / across();
  }
  bool is_wide() const {
    std::size_t letters = 0;
    for (const std::string& word : points_.words()) letters += word.size();
    return letters > 40;
  }

  Frame::Grid grid() const {
    const int rows = lines_of_panels() * static_cast<int>(chart_.y.size());
    const int label = chart_.x.size() > 1 && chart_.x[0].text != chart_.x[1].text ? 22 : 0;
    const int numbers = 32 + label + (is_wide() ? 60 : 0);
    return {rows, across(), (rows == 1 ? 370 : 270) + numbers, 85, numbers, 45 - label};
  }

  std::vector<std::string> caption() const {
    std::vector<std::string> lines = chart_.notes;
    std::vector<Quantity> shown = chart_.x;
    for (const auto& y : chart_.y) shown.insert(shown.end(), y.begin(), y.end());
    for (std::string& line : table_.made(shown)) lines.push_back(std::move(line));
    return lines;
  }

  std::vector<std::vector<Curve>> legends() const {
    std::vector<Curve> colours, markers, rest;
    const bool curves = chart_.kind == Chart::Kind::curves;
    for (std::size_t k = 0; k < points_.colours().size() && points_.colours().size() > 1; ++k) {
      const Look look{k, curves ? k : 0};
      colours.push_back({"",
                         curves && chart_.joined ? "with linespoints " + look.line() + ' ' + shape(look)
                                                 : "with points " + look.filled(),
                         points_.colours().names()[k]});
    }
    for (std::size_t k = 0; k < points_.markers().size() && points_.markers().size() > 1 && !curves; ++k)
      markers.push_back({"",
                         chart_.joined ? "with linespoints " + grey(Look{0, k}.line()) + ' ' + shape({0, k})
                                       : "with points " + grey(Look{0, k}.filled()),
                         points_.markers().names()[k]});
    add_lines_to(rest);
    return {colours, markers, rest};
  }

  /// In no colour of the others.
  static std::string grey(std::string look) { return look.replace(look.find(colours[0]), 7, "#707070"); }

  /// Point type and size alone.
  static std::string shape(const Look& look) {
    const std::string filled = look.filled();
    return filled.substr(filled.find("pt "));
  }

  void add_lines_to(std::vector<Curve>& legend) const {
    if (chart_.front) legend.push_back({"", front_ring, "Pareto front"});
    for (std::size_t row = 0; row < chart_.y.size(); ++row)
      for (const auto& floor : points_.floors(row))
        if (floor && (legend.empty() || legend.back().title != "error of the reference"))
          legend.push_back({"", floor_line, "error of the reference"});
    if (chart_.tolerance) legend.push_back({"", reference_line, "tolerance"});
    for (const Line& line : chart_.lines)
      if (!line.name.empty()) legend.push_back({"", reference_line, line.name});
    if (overlay_) legend.push_back({"", overlay_points, chart_.overlay->name});
    for (const double slope : chart_.slopes)
      legend.push_back({"", "with lines lc rgb '#606060' lw 1", fmt::format("order {:g}", slope)});
  }

  bool any_failed(std::size_t row) const {
    return std::any_of(marks_[row].begin(), marks_[row].end(), [](const Mark& mark) { return !mark.y; });
  }

  double factor() const { return chart_.percent ? 100.0 : 1.0; }

  void draw_row(Frame& frame, std::size_t row) {
    Axis x('x', chart_.log_x, points_.words()), y('y', chart_.log_y);
    const auto overlaid = overlay_ ? points_.overlaid(row, *overlay_) : std::vector<Mark>();
    const auto floors = points_.floors(row);
    for (const auto* marks : {&std::as_const(marks_)[row], &overlaid})
      for (const Mark& mark : *marks) {
        if (mark.x) x.cover(*mark.x);
        if (mark.y) y.cover(*mark.y);
      }
    for (const auto& floor : floors)
      if (floor) y.cover(*floor);
    for (const Line& line : chart_.lines) {
      if (line.x) x.cover(*line.x);
      if (line.y) y.cover(factor() * *line.y);
    }
    if (chart_.tolerance) y.cover(factor() * *chart_.tolerance);
    if (any_failed(row)) {
      const std::size_t most = std::min(most_strip_rows, points_.colours().size());
      y.add_strip(static_cast<int>(most),
                  chart_.limit ? std::optional(factor() * *chart_.limit) : std::nullopt);
    }
    x.close(), y.close();
    for (std::size_t panel = 0; panel < points_.panels().size(); ++panel)
      draw_panel(frame, row, panel, x, y, overlaid, floors[panel]);
  }

  void draw_panel(Frame& frame, std::size_t row, std::size_t panel, const Axis& x, const Axis& y,
                  const std::vector<Mark>& overlaid, const std::optional<double>& floor) {
    Picture& picture = frame.picture();
    const int index = static_cast<int>(panel), column = index % across();
    const bool lowest = row + 1 == chart_.y.size() || chart_.x[row + 1].text != chart_.x[row].text;
    frame.go_to(static_cast<int>(row) * lines_of_panels() + index / across(), column,
                points_.panels()[panel]);
    picture.command(grid_command);
    const bool last_line = index + across() >= static_cast<int>(points_.panels().size());
    x.apply(picture, lowest && last_line ? table_.label(chart_.x[row], charts_, false) : "", true,
            static_cast<std::size_t>(24 / across()));
    y.apply(picture, column == 0 ? y_label(row) : "", column == 0);
    std::vector<Curve> curves;
    add_series(picture, row, panel, x, y, curves);
    add_lines(picture, x, y, floor, curves);
    if (chart_.front) add_front(picture, row, panel, y, curves);
    add_overlay(picture, panel, overlaid, y, curves);
    picture.plot(curves);
    picture.command("unset label 99");
  }

  std::string y_label(std::size_t row) const {
    if (chart_.y[row].size() == 1) return table_.label(chart_.y[row].front(), charts_, chart_.percent);
    return chart_.percent ? "[%]" : "";
  }

  /// Words that stand side by side have a place for each series.
  double shifted(const Mark& mark) const {
    if (points_.words().empty()) return *mark.x;
    const double count = static_cast<double>(points_.colours().size());
    return *mark.x + 0.8 * ((static_cast<double>(mark.look.colour) + 0.5) / count - 0.5);
  }

  void add_series(Picture& picture, std::size_t row, std::size_t panel, const Axis& x, const Axis& y,
                  std::vector<Curve>& curves) {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<const Mark*>> series;
    std::size_t nowhere = 0;
    for (const Mark& mark : marks_[row]) {
      if (mark.panel != panel) continue;
      if (mark.x && x.place(*mark.x))
        series[{mark.look.colour, mark.look.shape}].push_back(&mark);
      else
        ++nowhere;
    }
    if (any_failed(row)) label_strip(picture, y, nowhere);
    for (auto& [look, marks] : series) add_one_series(picture, marks, y, curves);
  }

  void label_strip(Picture& picture, const Axis& y, std::size_t nowhere) const {
    std::string text = chart_.limit ? fmt::format("failed, or above {:g}{}", factor() * *chart_.limit,
                                                  chart_.percent ? " %" : "")
                                    : "failed";
    if (nowhere > 0) text += fmt::format("; {} more have no place", nowhere);
    const int rows = static_cast<int>(std::min(most_strip_rows, points_.colours().size()));
    picture.command(
        fmt::format("set label 99 {} at graph 0.015, first {:.12g} left noenhanced font small tc rgb "
                    "'#404040'",
                    quote(text), y.strip(rows - 1)));
  }

  void add_one_series(Picture& picture, std::vector<const Mark*>& marks, const Axis& y,
                      std::vector<Curve>& curves) {
    const Look look = marks.front()->look;
    if (chart_.joined && points_.words().empty())
      std::stable_sort(marks.begin(), marks.end(),
                       [](const Mark* a, const Mark* b) { return *a->x < *b->x; });
    std::vector<Point> line, filled, hollow, failed;
    for (const Mark* mark : marks) {
      const auto at = mark->y ? y.place(*mark->y) : std::nullopt;
      const double x = shifted(*mark);
      line.push_back({x, at.value_or(undefined)});
      if (!at)
        failed.push_back({x, y.strip(static_cast<int>(look.colour % most_strip_rows))});
      else
        (mark->hollow ? hollow : filled).push_back({x, *at});
    }
    if (chart_.joined && points_.words().empty())
      curves.push_back({picture.data(line), "with lines " + look.line()});
    for (const auto* points : {&filled, &failed})
      if (!points->empty()) curves.push_back({picture.data(*points), "with points " + look.filled()});
    if (hollow.empty()) return;
    const std::string data = picture.data(hollow);
    curves.push_back({data, "with points " + look.white()});
    curves.push_back({data, "with points " + look.hollow()});
  }

  void add_lines(Picture& picture, const Axis& x, const Axis& y, const std::optional<double>& floor,
                 std::vector<Curve>& curves) const {
    const auto across = [&](double at, const char* style) {
      curves.push_back({picture.data({{x.low(), at}, {x.high(), at}}), style});
    };
    if (floor) across(*floor, floor_line);
    if (chart_.tolerance) across(factor() * *chart_.tolerance, reference_line);
    for (const Line& line : chart_.lines)
      if (line.y)
        across(factor() * *line.y, reference_line);
      else
        curves.push_back({picture.data({{*line.x, y.low()}, {*line.x, y.high()}}), reference_line});
    for (const double slope : chart_.slopes) {
      const double middle_x = std::sqrt(x.low() * x.high()), middle_y = std::sqrt(y.low() * y.high());
      curves.push_back({fmt::format("{:.9g}*(x/{:.9g})**{:.9g}", middle_y, middle_x, slope),
                        "with lines lc rgb '#606060' lw 1"});
    }
  }

  void add_front(Picture& picture, std::size_t row, std::size_t panel, const Axis& y,
                 std::vector<Curve>& curves) const {
    std::vector<Point> points;
    for (const Mark& mark : marks_[row])
      if (mark.panel == panel && mark.x && mark.y && y.place(*mark.y)) points.push_back({*mark.x, *mark.y});
    const std::string front = picture.data(pareto_front(points));
    curves.push_back({front, front_line});
    curves.push_back({front, front_ring});
  }

  static void add_overlay(Picture& picture, std::size_t panel, const std::vector<Mark>& overlaid,
                          const Axis& y, std::vector<Curve>& curves) {
    std::vector<Point> points;
    for (const Mark& mark : overlaid)
      if (mark.panel == panel && mark.x && mark.y && y.place(*mark.y)) points.push_back({*mark.x, *mark.y});
    if (!points.empty()) curves.push_back({picture.data(points), overlay_points});
  }

  const Chart& chart_;
  const Charts& charts_;
  const Table& table_;
  const Table* overlay_;
  Points points_;
  std::vector<std::vector<Mark>> marks_;  ///< by row of panels
};

}  // namespace

Picture draw_points(const Chart& chart, const Charts& charts, const Table& table, const Table* overlay) {
  return PointsChart(chart, charts, table, overlay).drawn();
}

}  // namespace tandem::charts
