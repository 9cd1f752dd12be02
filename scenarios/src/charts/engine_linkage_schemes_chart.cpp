// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "charts/csv_table.hpp"
#include "charts/engine_linkage_charts.hpp"
#include "charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

using Work = std::vector<EngineLinkageWork>;

constexpr std::array<const char*, 3> schedules = {"slowest-first", "fastest-first", "parallel"};
constexpr double top = 20.0, bottom = 5e-4;  // [rad/s]; crosses stand at the first

struct Family {
  const char *name, *style;
  bool (*holds)(const EngineLinkageWork&);
};
bool equal(const EngineLinkageWork& w, const char* degree) {
  return w.to_fast == degree && w.to_slow == degree;
}
const Family families[] = {
    {"degree 0", "lc rgb '#000000' lw 1.6 pt 7 ps 0.7", [](const auto& w) { return equal(w, "lagrange0"); }},
    {"1", "lc rgb '#E69F00' lw 1.6 pt 9 ps 0.7", [](const auto& w) { return equal(w, "lagrange1"); }},
    {"2", "lc rgb '#56B4E9' lw 1.6 pt 5 ps 0.7", [](const auto& w) { return equal(w, "lagrange2"); }},
    {"3", "lc rgb '#D55E00' lw 1.6 pt 13 ps 0.7", [](const auto& w) { return equal(w, "lagrange3"); }},
    {"4", "lc rgb '#0072B2' lw 1.6 pt 11 ps 0.7", [](const auto& w) { return equal(w, "lagrange4"); }},
    {"speed by hermite, torque held", "lc rgb '#009E73' lw 1.6 dt '-' pt 6 ps 0.9",
     [](const auto& w) { return w.to_fast == "hermite" && w.to_slow == "lagrange0"; }},
    {"speed by hermite, torque of degree 1", "lc rgb '#A0307A' lw 1.6 dt '-' pt 4 ps 0.9",
     [](const auto& w) { return w.to_fast == "hermite" && w.to_slow == "lagrange1"; }},
    {"speed by hermite, mean torque", "lc rgb '#606060' lw 1.6 dt '.' pt 8 ps 0.9",
     [](const auto& w) { return w.to_fast == "hermite" && w.to_slow == "mean"; }},
    {"speed of degree 1, mean torque", "lc rgb '#A0A0A0' lw 1.6 dt '.' pt 12 ps 0.9",
     [](const auto& w) { return w.to_fast == "lagrange1" && w.to_slow == "mean"; }}};

bool failed(const EngineLinkageWork& w) { return !std::isfinite(w.speed_error); }

Work select(const Work& all, const char* schedule, const Family& family) {
  Work some;
  for (const auto& w : all)
    if (w.schedule == schedule && family.holds(w)) some.push_back(w);
  return some;
}

std::vector<Curve> legend() {
  std::vector<Curve> curves;
  for (const Family& f : families) curves.push_back({"", std::string("with linespoints ") + f.style, f.name});
  curves.push_back({"", "with points pt 2 ps 1.2 lw 2 lc rgb '#D55E00'", "unstable"});
  return curves;
}

std::vector<Curve> curves_of(Picture& picture, const Work& all, const char* schedule) {
  std::vector<Curve> curves;
  std::vector<Point> crosses;
  for (const Family& family : families) {
    std::vector<Point> points;
    for (const auto& w : select(all, schedule, family)) {
      points.push_back({w.step_ratio, failed(w) ? NAN : w.speed_error});
      if (failed(w)) crosses.push_back({w.step_ratio, top});
    }
    if (!points.empty())
      curves.push_back({picture.data(points), std::string("with linespoints ") + family.style});
  }
  if (!crosses.empty())
    curves.push_back({picture.data(crosses), "with points pt 2 ps 1.2 lw 2 lc rgb '#D55E00'"});
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
  picture.legend({0.03, 0.97, 0.84, 0.94}, legend(), 5);
  picture.command(std::string(grid_command) + "; unset key; set logscale xy; set format y '%g'");
  picture.command(fmt::format("set xrange [0.8:60]; set xtics (1, 2, 5, 10, 20, 50); set yrange [{}:{}]",
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

Picture engine_linkage_work_chart(const Work& work, const std::vector<std::string>& caption) {
  refuse_empty(work);
  Picture picture("engine_linkage_work", 1000, 640);
  picture.title("The linkage driven by the engine: error against the time of 30 s of motion");
  picture.caption(caption);
  std::vector<Curve> curves, names;
  constexpr const char* looks[] = {"lc rgb '#0072B2' pt 7", "lc rgb '#E69F00' pt 9", "lc rgb '#56B4E9' pt 4"};
  for (std::size_t k = 0; k < schedules.size(); ++k) {
    std::vector<Point> points;
    for (const auto& w : work)
      if (w.schedule == schedules[k] && !failed(w)) points.push_back({w.seconds, w.speed_error});
    const std::string style = fmt::format("with points {} ps 0.9", looks[k]);
    if (!points.empty()) curves.push_back({picture.data(points), style});
    names.push_back({"", style, schedules[k]});
  }
  picture.legend({0.1, 0.9, 0.88, 0.94}, names, 3);
  picture.command(std::string(grid_command) + "; unset key; set logscale xy; set format xy '%g'");
  picture.command("set xlabel 'time of a run [s]'; set ylabel 'largest error of the speed [rad/s]'");
  picture.panel({0.1, 0.97, 0.17, 0.86});
  picture.plot(curves);
  return picture;
}

}  // namespace tandem::charts
