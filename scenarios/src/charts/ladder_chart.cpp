// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/ladder_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

using Ladder = std::vector<LadderPoint>;

std::vector<std::string> quantities(const Ladder& points) {
  std::vector<std::string> names;
  for (const LadderPoint& p : points)
    if (names.empty() || names.back() != p.quantity) names.push_back(p.quantity);
  return names;
}

Ladder of(const Ladder& points, const std::string& quantity) {
  Ladder some;
  std::copy_if(points.begin(), points.end(), std::back_inserter(some),
               [&](const LadderPoint& p) { return p.quantity == quantity; });
  return some;
}

/// Of one panel: from a tenth of the smallest to ten times the largest difference or tolerance.
struct Range {
  double low, high;
};
Range range(const Ladder& points) {
  Range r{points[0].tolerance, points[0].tolerance};
  for (const LadderPoint& p : points)
    if (p.difference > 0.0) r = {std::min(r.low, p.difference), std::max(r.high, p.difference)};
  return {0.1 * r.low, 10.0 * r.high};
}

/// Which number is which rung, from the lower left corner of the panel upwards.
void list_rungs(Picture& picture, const Ladder& points) {
  for (std::size_t k = 0; k < points.size(); ++k)
    picture.command(fmt::format("set label {} at graph 0.015,{:.3f} noenhanced font small",
                                quote(fmt::format("{}: {}", k + 1, points[k].rung)),
                                0.05 + 0.055 * static_cast<double>(points.size() - 1 - k)));
}

/// A rung without times stands where the dearest stands.
double place_of(const LadderPoint& p, const Range& r) {
  if (std::isnan(p.difference)) return 0.5 * r.high;
  return std::max(p.difference, 2.0 * r.low);
}

void draw(Picture& picture, const Ladder& points, double left, double right) {
  const Range r = range(points);
  std::vector<Curve> curves = {
      {fmt::format("{:.6g}", points[0].tolerance), "with lines lc rgb '#D55E00' lw 1.6 dt '-'"}};
  std::vector<Point> met, beyond;
  int number = 0;
  for (const LadderPoint& p : points) {
    const double x = std::isnan(p.seconds) ? right : p.seconds, y = place_of(p, r);
    (p.difference <= p.tolerance ? met : beyond).push_back({x, y});
    picture.command(fmt::format("set label '{}' at {:.6g},{:.6g} offset 0.5,0.6 font small", ++number, x, y));
  }
  if (!met.empty()) curves.push_back({picture.data(met), "with points lc rgb '#0072B2' pt 7 ps 1.2"});
  if (!beyond.empty())
    curves.push_back({picture.data(beyond), "with points lc rgb '#D55E00' pt 2 ps 1.2 lw 2"});
  picture.command(fmt::format("set xrange [{:.6g}:{:.6g}]; set yrange [{:.6g}:{:.6g}]", left, 4.0 * right,
                              r.low, r.high));
  picture.plot(curves);
  picture.command("unset label");
}

}  // namespace

Ladder read_ladder(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file, {"rung", "quantity", "unit", "difference", "tolerance", "seconds"});
  Ladder points;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    points.push_back({row.text("rung"), row.text("quantity"), row.text("unit"), row.number("difference"),
                      row.positive("tolerance"), row.number("seconds")});
  }
  return points;
}

Picture ladder_chart(const Ladder& points, const std::vector<std::string>& caption) {
  if (points.empty()) throw Error(ErrorCode::input_output, "ladder.csv has no rows");
  double left = INFINITY, right = 0.0;
  for (const LadderPoint& p : points)
    if (p.seconds > 0.0) left = std::min(left, p.seconds), right = std::max(right, p.seconds);
  if (!(right > 0.0)) throw Error(ErrorCode::input_output, "ladder.csv has no times; --repetitions was 0");
  const auto names = quantities(points);
  Picture picture("ladder", 1000, 120 + 400 * static_cast<int>(names.size()));
  picture.title("Difference from the richest model against the processor time of a run");
  picture.caption(caption);
  picture.legend({0.1, 0.9, 1.0 - 70.0 / picture.height(), 1.0 - 30.0 / picture.height()},
                 {{"", "with points lc rgb '#0072B2' pt 7 ps 1.2", "within the tolerance (0 at the foot)"},
                  {"", "with points lc rgb '#D55E00' pt 2 ps 1.2 lw 2", "beyond, or none (at the top)"},
                  {"", "with lines lc rgb '#D55E00' lw 1.6 dt '-'", "tolerance"}},
                 3);
  picture.command(std::string(grid_command) + "; unset key; set logscale xy; set format xy '%g'");
  picture.command("set xlabel 'processor time [s]'");
  const double top = 1.0 - 70.0 / picture.height(),
               height = (top - 50.0 / picture.height()) / static_cast<double>(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Ladder some = of(points, names[k]);
    const double upper = top - height * static_cast<double>(k);
    picture.command("set ylabel " +
                    quote(names[k] + (some[0].unit == "1" ? " [fraction]" : " [" + some[0].unit + "]")) +
                    " noenhanced");
    picture.panel({0.12, 0.97, upper - height + 60.0 / picture.height(), upper - 10.0 / picture.height()});
    list_rungs(picture, some);
    draw(picture, some, 0.5 * left, right);
  }
  return picture;
}

}  // namespace tandem::charts
