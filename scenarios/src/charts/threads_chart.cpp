// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/threads_chart.hpp"

#include <fmt/format.h>

#include <set>

#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

using Times = std::vector<ThreadTime>;

std::vector<Curve> curves_of(Picture& picture, const Times& times, double ThreadTime::*what) {
  std::set<double> counts;
  for (const ThreadTime& t : times) counts.insert(t.threads);
  std::vector<Curve> curves;
  for (const double count : counts) {
    std::vector<Point> points;
    for (const ThreadTime& t : times)
      if (t.threads == count) points.push_back({t.variables, t.*what});
    const int k = static_cast<int>(curves.size());
    curves.push_back({picture.data(points), "with linespoints " + line_and_marker_of(k),
                      fmt::format("{:g} thread{}", count, count > 1.0 ? "s" : "")});
  }
  return curves;
}

}  // namespace

Times read_thread_times(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file, {"variables", "threads", "ns_per_step_variable", "speed_up"});
  Times times;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    times.push_back({row.positive("variables"), row.positive("threads"), row.positive("ns_per_step_variable"),
                     row.positive("speed_up")});
  }
  return times;
}

Picture threads_chart(const Times& times, const std::vector<std::string>& caption) {
  if (times.empty()) throw Error(ErrorCode::input_output, "threads.csv has no rows");
  Picture picture("threads", 1200, 560);
  picture.title("Threads that share a step of the N-fold four-bar linkage");
  picture.caption(caption);
  auto speed_ups = curves_of(picture, times, &ThreadTime::speed_up);
  picture.legend({0.3, 0.7, 0.86, 0.94}, speed_ups, static_cast<int>(speed_ups.size()));
  for (Curve& c : speed_ups) c.title.clear();
  picture.command(std::string(grid_command) + "; unset key; set logscale xy; set format xy '%g'");
  picture.command("set xlabel 'variables'; set ylabel 'speed-up beside one thread'");
  picture.command("set yrange [0.5:2]; set ytics (0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.2, 1.4, 1.6, 1.8, 2)");
  picture.panel({0.075, 0.49, 0.2, 0.84});
  picture.plot(speed_ups);
  picture.command("set ylabel 'time of a step and variable [ns]'; set yrange [20:200]");
  picture.command("set ytics (20, 30, 40, 50, 60, 80, 100, 150, 200)");
  picture.panel({0.57, 0.965, 0.2, 0.84});
  picture.plot(curves_of(picture, times, &ThreadTime::ns));
  return picture;
}

}  // namespace tandem::charts
