// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "charts/error_axis.hpp"
#include "charts/pareto.hpp"
#include "charts/style.hpp"
#include "charts/two_mass_charts.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

using Selection = std::vector<const Result*>;
using Cost = double Result::*;

/// What the marker's shape tells, from gnuplot's hollow point types; the filled one is the next.
struct Family {
  const char* name;
  int hollow;
  bool (*holds)(const Scheme&);
};
const Family families[] = {
    {"degree 0", 6, [](const Scheme& s) { return equal_degree(s) == 0; }},
    {"degree 1 to 4", 4, [](const Scheme& s) { return equal_degree(s) > 0; }},
    {"hermite", 12, [](const Scheme& s) { return s.to_fast == "hermite"; }},
    {"matched hold", 8, [](const Scheme& s) { return s.to_fast == "matched_hold"; }},
    {"smoothing", 10, [](const Scheme& s) { return s.to_slow == "mean"; }},
};

/// What the colour tells; hollow or filled, and light or dark, in grey.
struct Order {
  const char* schedule;
  const char* colour;
  bool filled;
};
const Order orders[] = {
    {"slowest-first", "#0072B2", true},
    {"staggered", "#000000", true},
    {"fastest-first", "#E69F00", true},
    {"parallel", "#56B4E9", false},
};

std::string style_of(const Order& order, const Family& family) {
  return fmt::format("with points lc rgb '{}' pt {} ps 0.65 lw 1.2", order.colour,
                     family.hollow + (order.filled ? 1 : 0));
}

constexpr double ratios[] = {10.0, 30.0, 90.0};
constexpr double monolithic_steps = 100.0;  // per cycle, as in the sweep
const char* const monolithic_style = "with points lc rgb '#D55E00' pt 3 ps 1.1 lw 2";
const char* const monolithic_line = "with lines lc rgb '#D55E00' lw 1.2 dt '-'";
const char* const front_line = "with steps lc rgb '#000000' lw 1.2 dt 1";
const char* const front_ring = "with points lc rgb '#000000' pt 6 ps 1.3 lw 1";

Selection select(const Selection& rows, const Order& order, const Family& family) {
  Selection selection;
  for (const Result* r : rows)
    if (r->scheme.schedule == order.schedule && family.holds(r->scheme)) selection.push_back(r);
  return selection;
}

Selection at_ratio(const std::vector<Result>& work, double ratio) {
  Selection selection;
  for (const Result& r : work)
    if (r.frequency_ratio == ratio) selection.push_back(&r);
  if (selection.empty())
    throw Error(ErrorCode::input_output, fmt::format("work.csv has no row with frequency_ratio {}", ratio));
  return selection;
}

std::vector<Point> points_of(const Selection& rows, Cost cost, const ErrorAxis& axis) {
  std::vector<Point> points;
  for (const Result* r : rows)
    if (r->*cost > 0.0)
      points.push_back({r->*cost, axis.shows(r->error()) ? axis.place(r->error()) : axis.strip(0)});
  return points;
}

std::vector<Point> front_of(const Selection& rows, Cost cost, const ErrorAxis& axis) {
  std::vector<Point> points;
  for (const Result* r : rows)
    if (!r->scheme.monolithic() && axis.shows(r->error()))
      points.push_back({r->*cost, axis.place(r->error())});
  return pareto_front(points);
}

/// Failed runs have no run time, so a panel over the run time says how many there are.
std::string strip_text(const Selection& rows, Cost cost) {
  const auto lost = std::count_if(rows.begin(), rows.end(),
                                  [&](const Result* r) { return r->failed && !(r->*cost > 0.0); });
  return lost == 0 ? "failed, or above 50 %" : fmt::format("above 50 %; {} more failed (no run time)", lost);
}

/// A point over the run time. It exchanges nothing, so over the exchanges its error is a line.
Curve monolithic_curve(Picture& picture, const Selection& rows, const ErrorAxis& axis, Cost cost) {
  std::vector<Point> points;
  for (const Result* r : rows)
    if (r->scheme.monolithic() && r->steps_per_cycle == monolithic_steps)
      points.push_back({r->*cost, axis.place(r->error())});
  if (cost == &Result::seconds || points.empty()) return {picture.data(points), monolithic_style};
  return {fmt::format("{}", points.front().y), monolithic_line};
}

void draw_panel(Picture& picture, const Selection& rows, const ErrorAxis& axis, Cost cost) {
  axis.apply(picture, rows.front()->frequency_ratio == ratios[0] ? "error [%]" : "", strip_text(rows, cost));
  std::vector<Curve> curves = {{picture.data(front_of(rows, cost, axis)), front_line}};
  for (const Order& order : orders)
    for (const Family& family : families)
      curves.push_back(
          {picture.data(points_of(select(rows, order, family), cost, axis)), style_of(order, family)});
  curves.push_back({picture.data(front_of(rows, cost, axis)), front_ring});
  curves.push_back(monolithic_curve(picture, rows, axis, cost));
  picture.plot(curves);
  ErrorAxis::end(picture);
}

std::vector<Curve> legend(const std::vector<Result>& work) {
  std::vector<Curve> curves;
  Selection all;
  for (const Result& r : work) all.push_back(&r);
  for (const Order& order : orders)
    for (const Family& family : families)
      if (!select(all, order, family).empty())
        curves.push_back({"", style_of(order, family), fmt::format("{}, {}", order.schedule, family.name)});
  curves.push_back(
      {"", "with linespoints lc rgb '#000000' lw 1.2 pt 6 ps 1.3", "Pareto front of coupled runs"});
  curves.push_back({"", "with linespoints lc rgb '#D55E00' lw 1.2 dt '-' pt 3 ps 1.1",
                    fmt::format("monolithic, {} steps per cycle", monolithic_steps)});
  return curves;
}

double smallest_error(const std::vector<Result>& work) {
  double least = failure_limit;
  for (const Result& r : work)
    if (r.error() > 0.0 && (!r.scheme.monolithic() || r.steps_per_cycle == monolithic_steps))
      least = std::min(least, r.error());
  return least;
}

/// The same for all ratios.
void set_cost_axis(Picture& picture, const std::vector<Result>& work, Cost cost, const std::string& label) {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const Result& r : work) {
    if (r.scheme.monolithic() || !(r.*cost > 0.0)) continue;
    least = std::min(least, r.*cost);
    most = std::max(most, r.*cost);
  }
  picture.command(fmt::format("set logscale x; set xrange [{}:{}]; set format x '%g'; set xlabel {}",
                              least / 1.4, most * 1.4, quote(label)));
}

}  // namespace

Picture work_precision_chart(const std::vector<Result>& work, const Caption& caption) {
  Picture picture("work_precision", 1300, 1150);
  picture.title(
      "Error against cost at frequency ratios 10, 30 and 90: all schemes, 25 to 400 steps per cycle");
  Caption lines = {
      "Error: the larger of position error and amplitude error of the fast mode. Run time: the least of the "
      "repetitions."};
  lines.insert(lines.end(), caption.begin(), caption.end());
  picture.caption(lines);
  picture.legend({0.02, 0.98, 0.875, 0.97}, legend(work), 3);
  picture.command(grid_command);
  const ErrorAxis axis(smallest_error(work), 2);
  for (std::size_t column = 0; column < 3; ++column) {
    const Selection rows = at_ratio(work, ratios[column]);
    const double left = 0.065 + 0.315 * static_cast<double>(column), right = left + 0.285;
    picture.command(fmt::format("set title 'frequency ratio {}' offset 0,-0.5", ratios[column]));
    set_cost_axis(picture, work, &Result::seconds, "run time [s]");
    picture.panel({left, right, 0.525, 0.84});
    draw_panel(picture, rows, axis, &Result::seconds);
    set_cost_axis(picture, work, &Result::exchanges, "exchanges");
    picture.panel({left, right, 0.11, 0.445});
    draw_panel(picture, rows, axis, &Result::exchanges);
  }
  return picture;
}

}  // namespace tandem::charts
