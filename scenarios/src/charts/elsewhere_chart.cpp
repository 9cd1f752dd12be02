// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/elsewhere_chart.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

using Times = std::vector<ElsewhereTime>;

/// In the order of the table.
std::vector<std::string> transports_of(const Times& times) {
  std::vector<std::string> names;
  for (const ElsewhereTime& t : times)
    if (std::find(names.begin(), names.end(), t.transport) == names.end()) names.push_back(t.transport);
  return names;
}

/// The first one on top.
std::vector<Curve> curves_of(Picture& picture, const Times& times, double loops) {
  const auto names = transports_of(times);
  const auto points = [&](const std::string& side) {
    std::vector<Point> all;
    for (const ElsewhereTime& t : times)
      if (t.loops == loops && t.side == side)
        all.push_back({t.seconds, static_cast<double>(names.end() -
                                                      std::find(names.begin(), names.end(), t.transport))});
    return picture.data(all);
  };
  return {{points("none"), "with points pt 5 ps 0.9 lc rgb '#000000'", "nothing elsewhere"},
          {points("engine"), "with points pt 7 ps 0.9 lc rgb '#0072B2'", "engine elsewhere"},
          {points("linkage"), "with points pt 2 ps 1.1 lc rgb '#D55E00'", "linkage elsewhere"}};
}

std::string as_tics(const std::vector<std::string>& names, bool shown) {
  std::vector<std::string> tics;
  for (std::size_t k = 0; k < names.size(); ++k)
    tics.push_back(fmt::format("{} {}", quote(shown ? names[k] : ""), names.size() - k));
  return fmt::format("set ytics ({})", fmt::join(tics, ", "));
}

}  // namespace

Times read_elsewhere_times(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file, {"loops", "elsewhere", "transport", "seconds"});
  Times times;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    times.push_back(
        {row.positive("loops"), row.text("elsewhere"), row.text("transport"), row.positive("seconds")});
  }
  return times;
}

Picture elsewhere_chart(const Times& times, const std::vector<std::string>& caption) {
  if (times.empty())
    throw Error(ErrorCode::input_output, "engine_linkage.csv has no rows; allowed are one or more");
  std::set<double> counts;
  for (const ElsewhereTime& t : times) counts.insert(t.loops);
  const auto names = transports_of(times);
  Picture picture("engine_linkage_elsewhere", 1200, static_cast<int>(190 + 26 * names.size()));
  picture.title("30 s of the linkage driven by the engine, one of them elsewhere");
  picture.caption(caption);
  const auto curves = curves_of(picture, times, *counts.begin());
  picture.legend({0.2, 0.8, 0.9, 0.93}, curves, static_cast<int>(curves.size()));
  picture.command(std::string(grid_command) + "; unset key; set logscale x; set format x '%g'");
  const auto [least, most] = std::minmax_element(
      times.begin(), times.end(),
      [](const ElsewhereTime& a, const ElsewhereTime& b) { return a.seconds < b.seconds; });
  picture.command(fmt::format("set xrange [{:g}:{:g}]", 0.5 * least->seconds, 1.9 * most->seconds));
  picture.command(fmt::format("set xlabel 'elapsed time [s]'; set yrange [0.4:{}]",
                              static_cast<double>(names.size()) + 0.6));
  double left = 0.1;
  const double width = 0.88 / static_cast<double>(counts.size());
  for (const double count : counts) {
    picture.command(fmt::format("set title '{:g} loop{}' offset 0,-0.6", count, count > 1.0 ? "s" : ""));
    picture.command(as_tics(names, count == *counts.begin()));
    picture.panel({left, left + width - 0.02, 0.22, 0.8});
    picture.plot(curves_of(picture, times, count));
    left += width;
  }
  return picture;
}

}  // namespace tandem::charts
