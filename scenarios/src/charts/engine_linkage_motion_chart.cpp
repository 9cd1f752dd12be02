// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "charts/engine_linkage_charts.hpp"
#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

void plot_over_time(Picture& picture, const Box& box, const std::vector<Point>& points, const char* label) {
  picture.command(fmt::format("set ylabel '{}'", label));
  picture.panel(box);
  picture.plot({{picture.data(points), "with lines " + line_of(0)}});
}

}  // namespace

EngineLinkageMotion read_engine_linkage_motion(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file, {"time", "linkage.speed", "engine.torque", "engine.throttle"});
  EngineLinkageMotion motion;
  for (std::size_t k = 0; k < table.size(); k += 10) {  // every tenth millisecond is what a picture shows
    const auto row = table[k];
    const double t = row.number("time");
    motion.throttle.push_back({t, row.number("engine.throttle")});
    motion.speed.push_back({t, row.number("linkage.speed")});
    motion.torque.push_back({t, row.number("engine.torque")});
  }
  return motion;
}

Picture engine_linkage_motion_chart(const EngineLinkageMotion& motion,
                                    const std::vector<std::string>& caption) {
  if (motion.speed.empty()) throw Error(ErrorCode::input_output, "results.csv has no rows");
  Picture picture("engine_linkage_motion", 1000, 760);
  picture.title("The linkage of one loop driven by the engine");
  picture.caption(caption);
  picture.command(std::string(grid_command) + "; unset key; set xrange [0:30]; set format x ''");
  plot_over_time(picture, {0.1, 0.97, 0.72, 0.92}, motion.throttle, "throttle [deg]");
  plot_over_time(picture, {0.1, 0.97, 0.44, 0.69}, motion.speed, "speed of the bar [rad/s]");
  picture.command("set xlabel 'time [s]'; set format x '%g'");
  plot_over_time(picture, {0.1, 0.97, 0.15, 0.41}, motion.torque, "torque on the bar [N m]");
  return picture;
}

std::vector<EngineLinkageElapsed> read_engine_linkage_elapsed(const std::filesystem::path& file) {
  const auto table = CsvTable::read(
      file, {"variables", "seconds", "engine_seconds", "linkage_seconds", "coordinator_seconds"});
  std::vector<EngineLinkageElapsed> elapsed;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    elapsed.push_back({row.positive("variables"), row.positive("seconds"), row.positive("engine_seconds"),
                       row.positive("linkage_seconds"), row.positive("coordinator_seconds")});
  }
  return elapsed;
}

Picture engine_linkage_elapsed_chart(const std::vector<EngineLinkageElapsed>& elapsed,
                                     const std::vector<std::string>& caption) {
  if (elapsed.empty()) throw Error(ErrorCode::input_output, "elapsed.csv has no rows");
  struct Part {
    const char* name;
    double EngineLinkageElapsed::*seconds;
  };
  constexpr Part parts[] = {{"all", &EngineLinkageElapsed::total},
                            {"linkage", &EngineLinkageElapsed::linkage},
                            {"engine", &EngineLinkageElapsed::engine},
                            {"coordinator", &EngineLinkageElapsed::coordinator}};
  Picture picture("engine_linkage_elapsed", 1000, 620);
  picture.title("Time of 30 s of linkage and engine, both with steps of 1 ms");
  picture.caption(caption);
  std::vector<Curve> curves, names;
  for (const Part& part : parts) {
    std::vector<Point> points;
    for (const auto& e : elapsed) points.push_back({e.variables, e.*part.seconds});
    const std::string style = "with linespoints " + line_and_marker_of(static_cast<int>(names.size()));
    curves.push_back({picture.data(points), style});
    names.push_back({"", style, part.name});
  }
  const std::string limit = "with lines lc rgb '#D55E00' lw 2 dt '-'";
  curves.push_back({"30", limit});
  names.push_back({"", limit, "real time"});
  picture.legend({0.05, 0.95, 0.88, 0.94}, names, 5);
  picture.command(std::string(grid_command) + "; unset key; set logscale xy; set format xy '%g'");
  picture.command("set xlabel 'variables of the linkage'; set ylabel 'time [s]'; set yrange [:100]");
  picture.panel({0.1, 0.97, 0.17, 0.86});
  picture.plot(curves);
  return picture;
}

}  // namespace tandem::charts
