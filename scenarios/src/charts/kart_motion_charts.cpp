// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "charts/kart_charts.hpp"
#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/stack.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

using Columns = std::map<std::string, std::vector<Point>>;
constexpr const char* columns[] = {"difference", "throttle",   "gear",      "torque",     "pitch",
                                   "speed",      "front_load", "rear_load", "front_slip", "rear_slip"};

bool empty(const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(), [](const Point& p) { return std::isnan(p.y); });
}

/// Line k of a panel.
struct Line {
  const KartLevel::Run& run;
  const char* column;
  int look;
};

void draw(Picture& picture, const std::vector<Line>& lines) {
  std::vector<Curve> curves;
  for (const Line& l : lines)
    curves.push_back({picture.data(l.run.columns.at(l.column)), "with lines " + line_of(l.look)});
  picture.plot(curves);
}

const KartLevel::Run& run_of(const KartLevel& level, const char* name) {
  const auto it = level.runs.find(name);
  if (it == level.runs.end())
    throw Error(ErrorCode::input_output,
                fmt::format("traces.csv has no run '{}' of level {}", name, level.name));
  return it->second;
}

/// One panel for each list of lines, with a title, below what stands at the top.
using Panels = std::vector<std::pair<const char*, std::vector<Line>>>;
void draw(Picture& picture, const Panels& panels) {
  picture.command("unset key; set xrange [0:10]; set offsets graph 0, graph 0, graph 0.08, graph 0.08");
  Stack stack(picture, panels.size(), "");
  for (const auto& [title, lines] : panels) {
    stack.next(title);
    stack.go_to(0.08, 0.97);
    draw(picture, lines);
  }
}

/// Upright lines at the changes of gear, for this panel and the later ones.
void mark_gears(Picture& picture, const std::vector<Point>& gear) {
  for (std::size_t k = 1; k < gear.size(); ++k)
    if (gear[k].y != gear[k - 1].y)
      picture.command(fmt::format(
          "set arrow from {0},graph 0 to {0},graph 1 nohead dt '.' lc rgb '#606060' lw 1.2", gear[k].x));
}

Picture stacked(const char* name, const KartLevel& level, const std::vector<std::string>& caption,
                const std::string& title) {
  Picture picture(fmt::format("kart_{}_{}", name, level.name), 1000, 900);
  picture.title(title);
  picture.caption(caption);
  return picture;
}

}  // namespace

std::vector<KartLevel> read_kart_traces(const std::filesystem::path& file) {
  std::vector<std::string> needed(std::begin(columns), std::end(columns));
  for (const char* key : {"level", "run", "schedule", "to_fast", "to_slow", "time"}) needed.emplace_back(key);
  const auto table = CsvTable::read(file, needed);
  std::vector<KartLevel> levels;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    if (levels.empty() || levels.back().name != row.name("level")) levels.push_back({row.name("level"), {}});
    KartLevel::Run& run = levels.back().runs[row.text("run")];
    run.scheme = row.text("schedule") + ", " + row.text("to_fast") + ", " + row.text("to_slow");
    for (const char* c : columns) run.columns[c].push_back({row.number("time"), row.number(c)});
  }
  for (KartLevel& level : levels)
    for (auto& named : level.runs)
      std::erase_if(named.second.columns, [](const auto& column) { return empty(column.second); });
  return levels;
}

Picture kart_pitch_chart(const KartLevel& level, const std::vector<std::string>& caption) {
  const auto &reference = run_of(level, "reference"), &worst = run_of(level, "worst"),
             &best = run_of(level, "best");
  const auto named = [](const char* which, const KartLevel::Run& run) {
    return fmt::format("{}: {}", which, run.scheme);
  };
  Picture picture =
      stacked("pitch", level, caption,
              "The kart (level " + level.name + ") with steps of 10 ms, its engine with 0.1 ms");
  picture.legend({0.05, 0.95, 0.935, 0.97},
                 {{"", "with lines " + line_of(0), "reference"},
                  {"", "with lines " + line_of(3), named("worst", worst)},
                  {"", "with lines " + line_of(5), named("best", best)}},
                 3);
  mark_gears(picture, reference.columns.at("gear"));
  draw(picture, Panels{{"throttle [deg]; dotted: changes of gear", {{reference, "throttle", 0}}},
                       {"pitch, nose down positive [deg]",
                        {{worst, "pitch", 3}, {best, "pitch", 5}, {reference, "pitch", 0}}},
                       {"difference of the worst scheme [deg]", {{worst, "difference", 3}}},
                       {"difference of the best scheme [deg]", {{best, "difference", 5}}}});
  return picture;
}

Picture kart_course_chart(const KartLevel& level, const std::vector<std::string>& caption) {
  const auto& run = run_of(level, "reference");
  Panels panels = {{"torque of the driven shaft [N m]", {{run, "torque", 0}}},
                   {"speed [m/s]", {{run, "speed", 0}}},
                   {"gear", {{run, "gear", 0}}}};
  if (run.columns.contains("front_load")) {
    panels.push_back(
        {"load of a wheel, front and (red) rear [N]", {{run, "front_load", 0}, {run, "rear_load", 3}}});
    panels.push_back(
        {"slip of a wheel, front and (red) rear", {{run, "front_slip", 0}, {run, "rear_slip", 3}}});
  }
  Picture picture =
      stacked("course", level, caption, "The kart's manoeuvre at level " + level.name + ", reference");
  mark_gears(picture, run.columns.at("gear"));
  draw(picture, panels);
  return picture;
}

}  // namespace tandem::charts
