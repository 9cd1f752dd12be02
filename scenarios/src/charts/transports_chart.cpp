// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/transports_chart.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

using TransportTimes = std::vector<TransportTime>;

std::string line_name(const TransportTime& t) {
  return t.wait == "none" ? t.transport : t.transport + ", " + t.wait;
}

/// In the order of the table.
std::vector<std::string> line_names(const TransportTimes& times) {
  std::vector<std::string> names;
  for (const TransportTime& t : times)
    if (std::find(names.begin(), names.end(), line_name(t)) == names.end()) names.push_back(line_name(t));
  return names;
}

/// The first one on top.
double height_of(const std::vector<std::string>& names, const TransportTime& t) {
  return static_cast<double>(names.end() - std::find(names.begin(), names.end(), line_name(t)));
}

std::vector<Curve> curves_of(Picture& picture, const TransportTimes& times, double samples) {
  const auto names = line_names(times);
  const auto points = [&](double TransportTime::*what) {
    std::vector<Point> all;
    for (const TransportTime& t : times)
      if (t.samples == samples) all.push_back({t.*what, height_of(names, t)});
    return picture.data(all);
  };
  return {
      {points(&TransportTime::raw_median), "with points pt 2 ps 1.1 lc rgb '#D55E00'",
       "the same bytes without tandem, median"},
      {points(&TransportTime::median), "with points pt 7 ps 0.9 lc rgb '#0072B2'", "tandem, median"},
      {points(&TransportTime::p99), "with points pt 6 ps 0.9 lc rgb '#0072B2'", "tandem, 99th percentile"}};
}

std::string names_as_tics(const std::vector<std::string>& names) {
  std::vector<std::string> tics;
  for (std::size_t k = 0; k < names.size(); ++k)
    tics.push_back(fmt::format("{} {}", quote(names[k]), names.size() - k));
  return fmt::format("({})", fmt::join(tics, ", "));
}

}  // namespace

TransportTimes read_transport_times(const std::filesystem::path& file) {
  const auto table = CsvTable::read(
      file, {"transport", "wait", "signals", "samples", "median_us", "p99_us", "raw_median_us"});
  TransportTimes times;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    times.push_back({row.text("transport"), row.text("wait"), row.positive("signals"),
                     row.positive("samples"), row.positive("median_us"), row.positive("p99_us"),
                     row.positive("raw_median_us")});
  }
  return times;
}

Picture transports_chart(const TransportTimes& times, const std::vector<std::string>& caption) {
  TransportTimes shown;
  std::copy_if(times.begin(), times.end(), std::back_inserter(shown),
               [](const TransportTime& t) { return t.signals == 4.0; });
  if (shown.empty())
    throw Error(ErrorCode::input_output, "transports.csv has no rows of 4 signals; allowed are one or more");
  std::set<double> counts;
  for (const TransportTime& t : shown) counts.insert(t.samples);
  const auto names = line_names(shown);
  Picture picture("transports", 1200, static_cast<int>(190 + 26 * names.size()));
  picture.title("Round trip of an advance with 4 signals of degree 3");
  picture.caption(caption);
  auto curves = curves_of(picture, shown, *counts.begin());
  picture.legend({0.1, 0.9, 0.85, 0.93}, curves, static_cast<int>(curves.size()));
  picture.command(std::string(grid_command) + "; unset key; set logscale x; set format x '%g'");
  picture.command(
      fmt::format("set xlabel 'microseconds'; set yrange [0.4:{}]", static_cast<double>(names.size()) + 0.6));
  auto labels = names;  // beside the first panel only
  double left = 0.12;
  const double width = 0.84 / static_cast<double>(counts.size());
  for (const double count : counts) {
    picture.command(
        fmt::format("set title '{:g} sample{} back' offset 0,-0.6", count, count > 1.0 ? "s" : ""));
    picture.command("set ytics " + names_as_tics(labels));
    picture.panel({left, left + width - 0.03, 0.22, 0.8});
    picture.plot(curves_of(picture, shown, count));
    left += width;
    labels.assign(names.size(), "");
  }
  return picture;
}

}  // namespace tandem::charts
