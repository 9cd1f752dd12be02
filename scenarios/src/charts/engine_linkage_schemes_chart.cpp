// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "charts/engine_linkage_charts.hpp"
#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

using Work = std::vector<EngineLinkageWork>;

constexpr std::array<const char*, 3> schedules = {"slowest-first", "fastest-first", "parallel"};
constexpr double top = 20.0, bottom = 5e-4;  // [rad/s]; crosses stand at the first

struct Family {
  const char *name, *to_fast, *to_slow, *colour, *line;
};
const Family families[] = {
    {"degree 0", "lagrange0", "lagrange0", "#000000", "pt 7"},
    {"1", "lagrange1", "lagrange1", "#E69F00", "pt 9"},
    {"2", "lagrange2", "lagrange2", "#56B4E9", "pt 5"},
    {"3", "lagrange3", "lagrange3", "#D55E00", "pt 13"},
    {"4", "lagrange4", "lagrange4", "#0072B2", "pt 11"},
    {"speed by hermite, torque held", "hermite", "lagrange0", "#009E73", "dt '-' pt 6"},
    {"and of degree 1", "hermite", "lagrange1", "#A0307A", "dt '-' pt 4"},
    {"and its mean", "hermite", "mean", "#606060", "dt '.' pt 8"},
    {"speed held, mean torque", "lagrange0", "mean", "#8C6D31", "dt '.' pt 12"},
    {"speed by least squares, mean torque", "least_squares1_2", "mean", "#7B4FD0", "dt '.' pt 10"}};

std::string look(const Family& f) { return fmt::format("lc rgb '{}' lw 1.6 {} ps 0.8", f.colour, f.line); }

bool failed(const EngineLinkageWork& w) { return !std::isfinite(w.speed_error); }

Work select(const Work& all, const char* schedule, const Family& family) {
  Work some;
  for (const auto& w : all)
    if (w.schedule == schedule && w.to_fast == family.to_fast && w.to_slow == family.to_slow)
      some.push_back(w);
  return some;
}

std::vector<Curve> legend() {
  std::vector<Curve> curves;
  for (const Family& f : families) curves.push_back({"", "with linespoints " + look(f), f.name});
  curves.push_back({"", "with points pt 2 ps 1.2 lw 2 lc rgb '#808080'", "unstable, each in its colour"});
  return curves;
}

/// A line for each scheme, and crosses of its colour where it is unstable, side by side.
std::vector<Curve> curves_of(Picture& picture, const Work& all, const char* schedule) {
  std::vector<Curve> curves;
  double beside = 0.82;
  for (const Family& family : families) {
    std::vector<Point> points, crosses;
    for (const auto& w : select(all, schedule, family)) {
      points.push_back({w.step_ratio, failed(w) ? NAN : w.speed_error});
      if (failed(w)) crosses.push_back({w.step_ratio * beside, top});
    }
    beside *= 1.045;
    if (!points.empty()) curves.push_back({picture.data(points), "with linespoints " + look(family)});
    if (!crosses.empty())
      curves.push_back(
          {picture.data(crosses), fmt::format("with points pt 2 ps 1.2 lw 2 lc rgb '{}'", family.colour)});
  }
  return curves;
}

void refuse_empty(const Work& work) {
  if (work.empty()) throw Error(ErrorCode::input_output, "work.csv has no rows");
}

}  // namespace

Work read_engine_linkage_work(const std::filesystem::path& file) {
  const auto table =
      CsvTable::read(file, {"schedule", "to_fast", "to_slow", "step_ratio", "max_speed_error", "seconds"});
  Work work;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    work.push_back({row.text("schedule"), row.text("to_fast"), row.text("to_slow"),
                    row.positive("step_ratio"), row.number("max_speed_error"), row.number("seconds")});
  }
  return work;
}

Picture engine_linkage_errors_chart(const Work& work, const std::vector<std::string>& caption) {
  refuse_empty(work);
  Picture picture("engine_linkage_errors", 1300, 600);
  picture.title(
      "The linkage driven by the engine: largest error of the bar's speed in 30 s, engine's step 0.1 ms");
  picture.caption(caption);
  picture.legend({0.03, 0.97, 0.84, 0.94}, legend(), 4);
  picture.command(std::string(grid_command) + "; unset key; set logscale xy; set format y '%g'");
  picture.command(fmt::format("set xrange [0.8:70]; set xtics (1, 2, 5, 10, 20, 50); set yrange [{}:{}]",
                              bottom, 1.6 * top));
  picture.command("set xlabel 'steps of the engine in one of the linkage'; set ylabel 'error [rad/s]'");
  for (std::size_t k = 0; k < schedules.size(); ++k) {
    const double left = 0.065 + 0.315 * static_cast<double>(k);
    picture.command(fmt::format("set title '{}' offset 0,-0.6", schedules[k]));
    if (k == 1) picture.command("unset ylabel");
    picture.panel({left, left + 0.275, 0.18, 0.78});
    picture.plot(curves_of(picture, work, schedules[k]));
  }
  return picture;
}

Picture engine_linkage_work_chart(const Work& work, double truth_seconds,
                                  const std::vector<std::string>& caption) {
  refuse_empty(work);
  Picture picture("engine_linkage_work", 1300, 740);
  picture.title("The linkage driven by the engine: error against the time of 30 s of motion");
  picture.caption(caption);
  std::vector<Curve> curves, names;
  for (const Family& f : families)
    names.push_back({"", fmt::format("with points pt 7 ps 0.9 lc rgb '{}'", f.colour), f.name});
  constexpr const char* marks[] = {"pt 7", "pt 9", "pt 4"};
  for (std::size_t k = 0; k < schedules.size(); ++k) {
    names.push_back({"", fmt::format("with points {} ps 0.9 lc rgb '#808080'", marks[k]), schedules[k]});
    for (const Family& f : families) {
      std::vector<Point> points;
      for (const auto& w : select(work, schedules[k], f))
        if (!failed(w)) points.push_back({w.seconds, w.speed_error});
      if (!points.empty())
        curves.push_back(
            {picture.data(points), fmt::format("with points {} ps 0.9 lc rgb '{}'", marks[k], f.colour)});
    }
  }
  names.push_back({"", "with lines dt 2 lw 1.6 lc rgb '#404040'", "the truth in one equation"});
  curves.push_back({picture.data({{truth_seconds, bottom}, {truth_seconds, top}}),
                    "with lines dt 2 lw 1.6 lc rgb '#404040'"});
  picture.legend({0.04, 0.96, 0.82, 0.95}, names, 3);
  picture.command(std::string(grid_command) + "; unset key; set logscale xy; set format xy '%g'");
  picture.command(fmt::format("set yrange [{}:{}]", bottom, top));
  picture.command("set xlabel 'time of a run [s]'; set ylabel 'largest error of the speed [rad/s]'");
  picture.panel({0.08, 0.97, 0.15, 0.8});
  picture.plot(curves);
  return picture;
}

}  // namespace tandem::charts
