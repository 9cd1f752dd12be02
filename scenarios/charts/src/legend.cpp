// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "legend.hpp"

#include <fmt/format.h>

namespace tandem::charts {
namespace {

std::string sample(const Look& look, bool joined) {
  const std::string filled = look.filled();
  return joined ? "with linespoints " + look.line() + ' ' + filled.substr(filled.find("pt "))
                : "with points " + filled;
}

/// In no colour of the others.
std::string grey(std::string style) { return style.replace(style.find(colours[0]), 7, "#707070"); }

std::vector<Curve> lines(const Chart& chart, bool has_floor) {
  std::vector<Curve> all;
  if (chart.front) all.push_back({"", front_ring, "Pareto front"});
  if (has_floor) all.push_back({"", floor_line, "error of the reference"});
  if (chart.tolerance) all.push_back({"", reference_line, "tolerance"});
  for (const Line& line : chart.lines)
    if (!line.name.empty()) all.push_back({"", reference_line, line.name});
  if (chart.overlay) all.push_back({"", overlay_points, chart.overlay->name});
  for (const double slope : chart.slopes) all.push_back({"", order_line, fmt::format("order {:g}", slope)});
  return all;
}

}  // namespace

std::vector<std::vector<Curve>> legends(const Chart& chart, const Points& points, bool has_floor) {
  std::vector<Curve> of_colours, of_markers;
  const bool curves = chart.kind == Chart::Kind::curves;
  const auto &colours = points.colours().names(), &markers = points.markers().names();
  for (std::size_t k = 0; k < colours.size() && colours.size() > 1; ++k)
    of_colours.push_back({"", sample({k, curves ? k : 0}, curves && points.words().empty()), colours[k]});
  for (std::size_t k = 0; k < markers.size() && markers.size() > 1 && !curves; ++k)
    of_markers.push_back({"", grey(sample({0, k}, chart.joined)), markers[k]});
  return {of_colours, of_markers, lines(chart, has_floor)};
}

}  // namespace tandem::charts
