// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/engine_charts.hpp"

#include <fmt/format.h>

#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/stack.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

using Caption = std::vector<std::string>;

Courses read_courses(const std::filesystem::path& file, const std::vector<std::string>& columns) {
  std::vector<std::string> all = columns;
  all.push_back("time");
  const auto table = CsvTable::read(file, all);
  Courses courses;
  for (std::size_t k = 0; k < table.size(); ++k)
    for (const auto& column : columns)
      courses[column].push_back({table[k].number("time"), table[k].number(column)});
  return courses;
}

const std::vector<Point>& points_of(const Courses& courses, const std::string& column) {
  const auto it = courses.find(column);
  if (it == courses.end()) throw Error(ErrorCode::input_output, "there are no rows");
  return it->second;
}

std::string line(int k) { return "with lines " + line_of(k); }

std::vector<Point> within(const std::vector<Point>& points, double begin, double end) {
  std::vector<Point> some;
  for (const Point& p : points)
    if (p.x >= begin && p.x <= end) some.push_back(p);
  return some;
}

/// A panel of one or two columns over a span of time.
struct Panel {
  const char* title;
  std::vector<const char*> columns;
  double tics;  ///< from one number of its axis to the next
};

void draw(Picture& picture, const Courses& courses, const Panel& panel, double begin, double end) {
  picture.command(fmt::format("set xrange [{}:{}]; set ytics {}", begin, end, panel.tics));
  std::vector<Curve> curves;
  for (const char* column : panel.columns)
    curves.push_back({picture.data(within(points_of(courses, column), begin, end)),
                      line(3 * static_cast<int>(curves.size()))});
  picture.plot(curves);
}

}  // namespace

TorqueMap read_torque_map(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file, {"rpm", "throttle", "torque"});
  TorqueMap map;
  for (std::size_t k = 0; k < table.size(); ++k)
    map[table[k].number("throttle")].push_back({table[k].number("rpm"), table[k].number("torque")});
  return map;
}

/// Each line has its plate angle at its right end.
Picture engine_torque_map_chart(const TorqueMap& map, const TorqueMap& printed, const Caption& caption) {
  if (map.empty()) throw Error(ErrorCode::input_output, "torque_map.csv has no rows");
  Picture picture("engine_torque_map", 1000, 620);
  picture.title("Steady torque of the engine by plate angle, over its credible range");
  picture.caption(caption);
  picture.legend({0.1, 0.9, 0.9, 0.94},
                 {{"", "with lines lc rgb '#0072B2' lw 1.6", "the diagram"},
                  {"", "with points pt 6 ps 0.9 lc rgb '#D55E00'", "printed in the specification"}},
                 2);
  picture.command(std::string(grid_command) +
                  "; unset key; set xrange [600:6400]; set xzeroaxis lt 1 lc rgb '#808080'");
  picture.command("set xlabel 'speed [rpm]'; set ylabel 'torque [N m]'");
  std::vector<Curve> curves;
  for (const auto& [throttle, points] : map) {
    picture.command(
        fmt::format("set label '{}°' at {},{} offset 0.6,0", throttle, points.back().x, points.back().y));
    curves.push_back({picture.data(points), "with lines lc rgb '#0072B2' lw 1.6"});
  }
  for (const auto& [throttle, points] : printed)
    curves.push_back({picture.data(points), "with points pt 6 ps 0.9 lc rgb '#D55E00'"});
  picture.panel({0.08, 0.97, 0.16, 0.88});
  picture.plot(curves);
  return picture;
}

Courses read_engine_step(const std::filesystem::path& file) {
  return read_courses(file, {"set", "rpm", "throttle", "torque"});
}

Picture engine_step_chart(const Courses& courses, const Caption& caption) {
  const Panel panels[] = {{"speed, and what is asked for [rpm]", {"rpm", "set"}, 500.0},
                          {"plate angle [deg]", {"throttle"}, 5.0},
                          {"torque [N m]; the load is 25 N m, from 2 to 8 s 20 N m", {"torque"}, 20.0}};
  Picture picture("engine_step", 1000, 760);
  picture.title("The governor's step from 2000 to 3000 rpm");
  picture.caption(caption);
  picture.command("unset key; set offsets graph 0, graph 0, graph 0.08, graph 0.08");
  Stack stack(picture, std::size(panels), "");
  for (const Panel& panel : panels) {
    stack.next(panel.title);
    stack.go_to(0.07, 0.97);
    draw(picture, courses, panel, 0.0, 10.0);
  }
  return picture;
}

Courses read_manoeuvre(const std::filesystem::path& file) {
  return read_courses(file, {"throttle", "ratio", "fill", "rpm", "torque", "pitch"});
}

Picture engine_gears_chart(const Courses& courses, const Caption& caption) {
  const Panel panels[] = {{"throttle [deg]", {"throttle"}, 4.0},
                          {"ratio, and fill of the converter (red)", {"ratio", "fill"}, 1.0},
                          {"engine [rpm]", {"rpm"}, 500.0},
                          {"torque of the driven shaft [N m]", {"torque"}, 40.0},
                          {"pitch [deg]", {"pitch"}, 1.0}};
  Picture picture("engine_gears", 1200, 1000);
  picture.title("The kart's manoeuvre with its automatic: the whole, and the changes to gears 2 and 3");
  picture.caption(caption);
  picture.command("unset key; set offsets graph 0, graph 0, graph 0.08, graph 0.08");
  Stack stack(picture, std::size(panels), "");
  for (const Panel& panel : panels) {
    stack.next(panel.title);
    stack.go_to(0.06, 0.56);
    draw(picture, courses, panel, 0.0, 10.0);
    stack.go_to(0.63, 0.98);
    draw(picture, courses, panel, 4.2, 5.2);
  }
  return picture;
}

}  // namespace tandem::charts
