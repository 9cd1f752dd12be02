// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/dense_chart.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

/// In the order of the file. At most six: style.hpp has no more.
std::vector<std::string> libraries_of(const std::vector<DenseTime>& times) {
  std::vector<std::string> names;
  for (const DenseTime& t : times)
    if (std::find(names.begin(), names.end(), t.library) == names.end()) names.push_back(t.library);
  return names;
}

std::vector<Curve> curves_of(Picture& picture, const std::vector<DenseTime>& times,
                             const std::string& operation) {
  std::vector<Curve> curves;
  const auto names = libraries_of(times);
  for (int k = 0; k < static_cast<int>(names.size()); ++k) {
    std::vector<Point> points;
    for (const DenseTime& t : times)
      if (t.library == names[k] && t.operation == operation) points.push_back({t.size, t.ns});
    if (!points.empty())
      curves.push_back({picture.data(points), "with linespoints " + line_and_marker_of(k)});
  }
  return curves;
}

std::vector<Curve> legend_of(const std::vector<DenseTime>& times) {
  std::vector<Curve> curves;
  const auto names = libraries_of(times);
  for (int k = 0; k < static_cast<int>(names.size()); ++k)
    curves.push_back({"", "with linespoints " + line_and_marker_of(k), names[k]});
  return curves;
}

}  // namespace

std::vector<DenseTime> read_dense_times(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file, {"library", "operation", "N", "ns"});
  std::vector<DenseTime> times;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    times.push_back({row.text("library"), row.text("operation"), row.positive("N"), row.positive("ns")});
  }
  return times;
}

Picture dense_chart(const std::vector<DenseTime>& times, const std::vector<std::string>& caption) {
  if (times.empty()) throw Error(ErrorCode::input_output, "dense.csv has no rows");
  Picture picture("dense", 1200, 600);
  picture.title("Small dense matrices by each BLAS, one thread");
  picture.caption(caption);
  picture.legend({0.03, 0.97, 0.86, 0.94}, legend_of(times), 3);
  picture.command(std::string(grid_command) + "; unset key");
  picture.command(
      "set logscale xy; set xrange [3.7:45]; set xtics (4, 8, 16, 24, 32, 42); set format y '%g'");
  picture.command("set xlabel 'N'; set ylabel 'time [ns]'; set title 'product' offset 0,-0.6");
  picture.panel({0.075, 0.49, 0.17, 0.81});
  picture.plot(curves_of(picture, times, "product"));
  picture.command("unset ylabel; set title 'Cholesky with one solution' offset 0,-0.6");
  picture.panel({0.56, 0.985, 0.17, 0.81});
  picture.plot(curves_of(picture, times, "cholesky"));
  return picture;
}

}  // namespace tandem::charts
