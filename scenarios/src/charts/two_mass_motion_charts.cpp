// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "charts/stack.hpp"
#include "charts/style.hpp"
#include "charts/two_mass_charts.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

using Selection = std::vector<const Trace*>;

Selection at_ratio(const std::vector<Trace>& traces, double ratio) {
  Selection selection;
  for (const Trace& t : traces)
    if (t.frequency_ratio == ratio) selection.push_back(&t);
  if (selection.empty())
    throw Error(ErrorCode::input_output, fmt::format("traces.csv has no row with frequency_ratio {}", ratio));
  return selection;
}

struct Span {
  double begin, end;  // [s]
};

/// All of the traces end at the same time, except those of failed runs.
double end_of(const Selection& selection) {
  double end = 0.0;
  for (const Trace* t : selection) end = std::max(end, t->time.back());
  return end;
}

using Values = std::vector<double> Trace::*;

/// The values within the span; of more than 3000 only every second, third ... is drawn, which no eye can
/// tell.
std::vector<Point> curve(const Trace& trace, Values values, Span span) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < trace.time.size(); ++k)
    if (trace.time[k] >= span.begin && trace.time[k] <= span.end)
      points.push_back({trace.time[k], (trace.*values)[k]});
  const std::size_t stride = points.size() / 3000 + 1;
  std::vector<Point> drawn;
  for (std::size_t k = 0; k < points.size(); k += stride) drawn.push_back(points[k]);
  return drawn;
}

const char* const exact_style = "with lines lc rgb '#A6A6A6' lw 4 dt 1";
const char* const computed_style = "with lines lc rgb '#0072B2' lw 1.3 dt 1";

/// A cross where a curve ends before its time.
Curve end_mark(Picture& picture, const std::vector<Point>& points) {
  return {picture.data({points.back()}), "with points pt 2 ps 1.2 lw 2.5 lc rgb '#D55E00'"};
}

void draw_failed_before(Picture& picture, Span span) {
  picture.command(fmt::format("set xrange [{}:{}]; set yrange [0:1]", span.begin, span.end));
  picture.command("set label 98 'the run failed before' at graph 0.5,0.5 center");
  picture.plot({{"NaN", "with lines"}});
  picture.command("unset label 98");
}

/// The motion of one scheme on top of the exact one. The axis is that of the exact motion and a quarter of it
/// more on either side, so that a run that leaves it is seen to leave.
void draw_motion(Picture& picture, const Trace& trace, Span span) {
  const auto exact = curve(trace, &Trace::x1_exact, span), computed = curve(trace, &Trace::x1, span);
  if (exact.empty()) return draw_failed_before(picture, span);
  const auto [low, high] =
      std::minmax_element(exact.begin(), exact.end(), [](Point a, Point b) { return a.y < b.y; });
  const double margin = 0.25 * (high->y - low->y);
  picture.command(fmt::format("set xrange [{}:{}]; set yrange [{}:{}]", span.begin, span.end, low->y - margin,
                              high->y + margin));
  std::vector<Curve> curves = {{picture.data(exact), exact_style}, {picture.data(computed), computed_style}};
  if (trace.time.back() < span.end) curves.push_back(end_mark(picture, computed));
  picture.plot(curves);
}

/// In percent; what is above failure_limit interrupts the curve.
std::vector<Point> energy_curve(const Trace& trace, double end) {
  std::vector<Point> points = curve(trace, &Trace::energy_error, {0.0, end});
  for (Point& p : points)
    p.y = std::abs(p.y) <= failure_limit ? 100.0 * p.y : std::numeric_limits<double>::quiet_NaN();
  return points;
}

/// The same axis for all, so that they can be compared.
void set_energy_range(Picture& picture, const Selection& selection, double end) {
  double low = 0.0, high = 0.0;
  for (const Trace* t : selection)
    for (const Point& p : energy_curve(*t, end)) low = std::fmin(low, p.y), high = std::fmax(high, p.y);
  const double margin = 0.05 * (high - low);
  picture.command(fmt::format("set xrange [0:{}]; set yrange [{}:{}]", end, low - margin, high + margin));
}

void draw_energy(Picture& picture, const Trace& trace, double end) {
  const std::vector<Point> points = energy_curve(trace, end);
  std::vector<Curve> curves = {{"0", "with lines lc rgb '#A6A6A6' lw 1"},
                               {picture.data(points), computed_style}};
  if (trace.time.back() < end) curves.push_back(end_mark(picture, points));
  picture.plot(curves);
}

void draw_legend(Picture& picture, const Box& box) {
  picture.legend(box, {{"", exact_style, "exact motion"}, {"", computed_style, "computed"}}, 2);
}

}  // namespace

Picture motion_fr90_chart(const std::vector<Trace>& traces, const Caption& caption) {
  const Selection selection = at_ratio(traces, 90.0);
  Picture picture("motion_fr90", 1200, 900);
  picture.title("Motion of the fast mass at frequency ratio 90, first 20 cycles of the fast mode");
  picture.caption(caption);
  draw_legend(picture, {0.05, 0.98, 0.93, 0.97});
  Stack stack(picture, selection.size(), "x1 [m]");
  for (const Trace* trace : selection) {
    stack.next(name_of(trace->scheme));
    stack.go_to(0.065, 0.985);
    draw_motion(picture, *trace, {0.0, 20.0});
  }
  return picture;
}

Picture motion_fr30_chart(const std::vector<Trace>& traces, const Caption& caption) {
  const Selection selection = at_ratio(traces, 30.0);
  const double end = end_of(selection);
  Picture picture("motion_fr30", 1200, 1000);
  picture.title(
      "Motion of the fast mass at frequency ratio 30: the whole run, and its last ten cycles of the fast "
      "mode");
  picture.caption(caption);
  draw_legend(picture, {0.05, 0.98, 0.93, 0.97});
  Stack stack(picture, selection.size(), "x1 [m]");
  for (const Trace* trace : selection) {
    stack.next(name_of(trace->scheme));
    stack.go_to(0.065, 0.6);
    draw_motion(picture, *trace, {0.0, end});
    stack.go_to(0.65, 0.985);
    picture.command("unset ylabel");
    draw_motion(picture, *trace, {end - 10.0, end});
  }
  return picture;
}

Picture energy_fr30_chart(const std::vector<Trace>& traces, const Caption& caption) {
  Selection cubic = at_ratio(traces, 30.0);
  std::erase_if(cubic, [](const Trace* t) { return equal_degree(t->scheme) != 3; });
  if (cubic.empty())
    throw Error(ErrorCode::input_output,
                "traces.csv has no row with frequency_ratio 30 and lagrange3 both ways");
  Picture picture("energy_fr30", 1200, 900);
  picture.title("Energy error over time at frequency ratio 30, polynomials of degree 3 both ways");
  picture.caption(caption);
  const double end = end_of(cubic);
  set_energy_range(picture, cubic, end);
  Stack stack(picture, cubic.size(), "(E - E0) / E0 [%]");
  for (const Trace* trace : cubic) {
    stack.next(name_of(trace->scheme));
    stack.go_to(0.075, 0.985);
    draw_energy(picture, *trace, end);
  }
  return picture;
}

}  // namespace tandem::charts
