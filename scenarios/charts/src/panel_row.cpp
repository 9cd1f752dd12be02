// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "panel_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tandem/charts/pareto.hpp"

namespace tandem::charts {
namespace {

constexpr std::size_t most_strip_rows = 5;
constexpr std::size_t most_marked = 60;  ///< points of a line, for markers to tell more than the line

std::string slope_line(double slope, const Axis& x, const Axis& y) {
  const double middle_x = std::sqrt(x.low() * x.high()), middle_y = std::sqrt(y.low() * y.high());
  return fmt::format("{:.9g}*(x/{:.9g})**{:.9g}", middle_y, middle_x, slope);
}

}  // namespace

PanelRow::PanelRow(const Chart& chart, const Points& points, std::size_t row, const Table* overlay)
    : chart_(chart),
      points_(points),
      factor_(chart.percent ? 100.0 : 1.0),
      marks_(points.marks(row)),
      overlaid_(overlay ? points.overlaid(row, *overlay) : std::vector<Mark>()),
      floors_(points.floors(row)),
      x_('x', chart.log_x, points.words()),
      y_('y', chart.log_y) {
  if (std::any_of(marks_.begin(), marks_.end(), [](const Mark& mark) { return !mark.y; }))
    strip_rows_ = std::min(most_strip_rows, points.colours().size());
  cover();
}

void PanelRow::cover() {
  for (const auto* marks : {&marks_, &overlaid_})
    for (const Mark& mark : *marks) {
      if (mark.x) x_.cover(*mark.x);
      if (mark.y) y_.cover(*mark.y);
    }
  for (const auto& floor : floors_)
    if (floor) y_.cover(*floor);
  for (const Line& line : chart_.lines) {
    if (line.x) x_.cover(*line.x);
    if (line.y) y_.cover(factor_ * *line.y);
  }
  if (chart_.tolerance) y_.cover(factor_ * *chart_.tolerance);
  if (strip_rows_ > 0)
    y_.add_strip(static_cast<int>(strip_rows_),
                 chart_.limit ? std::optional(factor_ * *chart_.limit) : std::nullopt);
  x_.close(), y_.close();
}

bool PanelRow::has_floor() const {
  return std::any_of(floors_.begin(), floors_.end(), [](const auto& floor) { return floor.has_value(); });
}

std::vector<Curve> PanelRow::curves(Picture& picture, std::size_t panel) const {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<const Mark*>> series;
  std::size_t nowhere = 0;
  for (const Mark& mark : marks_) {
    if (mark.panel != panel) continue;
    if (mark.x && x_.place(*mark.x))
      series[{mark.look.colour, mark.look.shape}].push_back(&mark);
    else
      ++nowhere;
  }
  if (strip_rows_ > 0) label_strip(picture, nowhere);
  std::vector<Curve> curves;
  for (auto& [look, marks] : series) add_series(picture, marks, curves);
  add_lines(picture, panel, curves);
  if (chart_.front) {
    const std::string front = picture.data(pareto_front(placed(marks_, panel)));
    curves.push_back({front, front_line}), curves.push_back({front, front_ring});
  }
  if (const auto over = placed(overlaid_, panel); !over.empty())
    curves.push_back({picture.data(over), overlay_points});
  return curves;
}

/// Words that stand side by side have a place for each series.
double PanelRow::shifted(const Mark& mark) const {
  if (points_.words().empty()) return *mark.x;
  const double count = static_cast<double>(points_.colours().size());
  return *mark.x + 0.8 * ((static_cast<double>(mark.look.colour) + 0.5) / count - 0.5);
}

void PanelRow::label_strip(Picture& picture, std::size_t nowhere) const {
  std::string text = "failed";
  if (chart_.limit)
    text += fmt::format(", or above {:g}{}", factor_ * *chart_.limit, chart_.percent ? " %" : "");
  if (nowhere > 0) text += fmt::format("; {} more have no place", nowhere);
  picture.command(
      fmt::format("set label 99 {} at graph 0.015, first {:.12g} left noenhanced font small tc rgb '#404040'",
                  quote(text), y_.strip(static_cast<int>(strip_rows_) - 1)));
}

void PanelRow::add_series(Picture& picture, std::vector<const Mark*>& marks, std::vector<Curve>& to) const {
  const Look look = marks.front()->look;
  const bool joined = chart_.joined && points_.words().empty();
  if (joined)
    std::stable_sort(marks.begin(), marks.end(), [](const Mark* a, const Mark* b) { return *a->x < *b->x; });
  std::vector<Point> line, filled, hollow, failed;
  for (const Mark* mark : marks) {
    const double x = shifted(*mark), y = mark->y ? y_.place(*mark->y).value_or(undefined) : undefined;
    line.push_back({x, y});
    if (!mark->y) failed.push_back({x, y_.strip(static_cast<int>(look.colour % most_strip_rows))});
    if (mark->y) (mark->hollow ? hollow : filled).push_back({x, y});
  }
  if (joined) to.push_back({picture.data(line), "with lines " + look.line()});
  if (joined && filled.size() > most_marked) filled.clear();
  for (const auto* points : {&filled, &failed})
    if (!points->empty()) to.push_back({picture.data(*points), "with points " + look.filled()});
  if (hollow.empty()) return;
  const std::string data = picture.data(hollow);
  to.push_back({data, "with points " + look.white()});
  to.push_back({data, "with points " + look.hollow()});
}

void PanelRow::add_lines(Picture& picture, std::size_t panel, std::vector<Curve>& to) const {
  const auto across = [&](double y, const char* style) {
    to.push_back({picture.data({{x_.low(), y}, {x_.high(), y}}), style});
  };
  if (floors_[panel]) across(*floors_[panel], floor_line);
  if (chart_.tolerance) across(factor_ * *chart_.tolerance, reference_line);
  for (const Line& line : chart_.lines)
    if (line.y)
      across(factor_ * *line.y, reference_line);
    else
      to.push_back({picture.data({{*line.x, y_.low()}, {*line.x, y_.high()}}), reference_line});
  for (const double slope : chart_.slopes) to.push_back({slope_line(slope, x_, y_), order_line});
}

/// Those of a panel that the axis can show.
std::vector<Point> PanelRow::placed(const std::vector<Mark>& marks, std::size_t panel) const {
  std::vector<Point> points;
  for (const Mark& mark : marks)
    if (mark.panel == panel && mark.x && mark.y && y_.place(*mark.y)) points.push_back({*mark.x, *mark.y});
  return points;
}

}  // namespace tandem::charts
