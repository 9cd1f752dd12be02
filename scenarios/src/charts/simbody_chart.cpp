// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/simbody_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tandem/charts/pareto.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

struct Family {
  const char *name, *colour;
  int point;
  const char* title;
};
constexpr std::array<Family, 5> families = {
    {{"Rod", "#D55E00", 9, "Simbody, L equations (Rod)"},
     {"PointOnLine", "#E69F00", 8, "Simbody, 2L equations (PointOnLine)"},
     {"index3", "#0072B2", 7, "tandem, index3"},
     {"penalty", "#009E73", 4, "tandem, penalty with rk4 or rk8"},
     {"index1", "#000000", 12, "tandem, index1 with rk4 or rk8"}}};

constexpr double least = 5e-6, limit = 1.0, top = 8.0;  // [m] above the limit: a strip for what is no result

using Runs = std::vector<const LinkageRun*>;

template <class Value>
std::vector<Value> values_of(const std::vector<LinkageRun>& runs, Value LinkageRun::*member) {
  std::vector<Value> values;
  for (const LinkageRun& r : runs)
    if (std::find(values.begin(), values.end(), r.*member) == values.end()) values.push_back(r.*member);
  return values;
}

Runs select(const std::vector<LinkageRun>& runs, const std::string& start, int loops) {
  Runs some;
  for (const LinkageRun& r : runs)
    if (r.start == start && r.loops == loops) some.push_back(&r);
  return some;
}

bool is_result(const LinkageRun& r) { return r.ok() && r.error < limit; }

std::vector<Curve> curves_of(Picture& picture, const Runs& runs) {
  std::vector<Curve> curves = {{"1e-3", "with lines lc rgb '#808080' lw 1 dt '-'"}};
  for (const Family& family : families) {
    std::vector<Point> results, others;
    for (const LinkageRun* r : runs) {
      if (r->family() != family.name) continue;
      if (is_result(*r))
        results.push_back({r->seconds, std::max(r->error, least)});
      else
        others.push_back({r->seconds, r->code == "simbody" ? 4.0 : 2.0});
    }
    const auto front = picture.data(pareto_front(results));
    curves.push_back({front, fmt::format("with lines lc rgb '{}' lw 1.4", family.colour)});
    curves.push_back({picture.data(results),
                      fmt::format("with points lc rgb '{}' pt {} ps 0.4", family.colour, family.point)});
    curves.push_back(
        {picture.data(others), fmt::format("with points lc rgb '{}' pt 2 ps 0.3", family.colour)});
  }
  return curves;
}

void draw_legend(Picture& picture) {
  std::vector<Curve> samples;
  for (const Family& f : families)
    samples.push_back(
        {"", fmt::format("with linespoints lc rgb '{}' lw 1.4 pt {} ps 0.6", f.colour, f.point), f.title});
  samples.push_back(
      {"", "with points lc rgb '#606060' pt 2 ps 0.5", "parallelogram lost, run failed or given up"});
  picture.legend({0.05, 0.95, 0.915, 0.965}, samples, 3);
}

/// Of all panels of a start.
void set_time_axis(Picture& picture, const std::vector<LinkageRun>& runs, const std::string& start) {
  double from = 1e300, to = 0.0;
  for (const LinkageRun& r : runs)
    if (r.start == start) from = std::min(from, r.seconds), to = std::max(to, r.seconds);
  picture.command(fmt::format("set xrange [{:g}:{:g}]", from / 1.5, to * 1.5));
}

}  // namespace

Picture simbody_chart(const std::vector<LinkageRun>& runs, const std::vector<std::string>& caption) {
  const auto starts = values_of(runs, &LinkageRun::start);
  const auto loops = values_of(runs, &LinkageRun::loops);
  Picture picture("simbody", 1400, static_cast<int>(150 + 330 * starts.size()));
  picture.title(
      "The linkage of L loops by Simbody and by tandem: error of the first point's path against time");
  picture.caption(caption);
  draw_legend(picture);
  picture.command(std::string(grid_command) + "; set logscale xy; set format x '10^{%T}'");
  picture.command(fmt::format("set yrange [{}:{}]; set ytics mirror", least, top));
  picture.command(
      fmt::format("set object 1 rectangle from graph 0, first {} to graph 1, graph 1 behind fc rgb '#E4E4E4' "
                  "fs solid noborder",
                  limit));
  const double height = 0.84 / static_cast<double>(starts.size()),
               width = 0.95 / static_cast<double>(loops.size());
  for (std::size_t row = 0; row < starts.size(); ++row) {
    set_time_axis(picture, runs, starts[row]);
    const double upper = 0.905 - height * static_cast<double>(row);
    picture.command(row + 1 == starts.size() ? "set xlabel 'processor time [s]'" : "unset xlabel");
    for (std::size_t column = 0; column < loops.size(); ++column) {
      const double left = 0.045 + width * static_cast<double>(column);
      picture.command(fmt::format("set title {} offset 0,-0.6 noenhanced",
                                  quote(fmt::format("{}, L = {}", starts[row], loops[column]))));
      picture.command(column == 0 ? "set ylabel 'rms error [m]'; set format y '10^{%T}'"
                                  : "unset ylabel; set format y ''");
      picture.panel({left, left + width - 0.015, upper - height + 0.045, upper - 0.02});
      picture.plot(curves_of(picture, select(runs, starts[row], loops[column])));
    }
  }
  return picture;
}

}  // namespace tandem::charts
