// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/flat_position_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

constexpr std::array<const char*, 4> formulations = {"index3", "penalty", "index1", "null_space"};
constexpr std::array<const char*, 5> integrators = {"newmark", "rk2", "rk4", "rk8", "generalized_alpha"};

constexpr const char* cross = "with points pt 2 ps 1.1 lw 2 lc rgb '#404040'";

struct Quantity {
  std::vector<double> Passage::*values;
  const char* label;
  double low, high;
};
constexpr std::array<Quantity, 2> quantities = {
    {{&Passage::tilt, "tilt of a coupler [m]", 1e-17, 10.0},
     {&Passage::angle_error, "error of the angle [rad]", 1e-12, 10.0}}};

std::vector<Point> points_of(const Passage& p, const Quantity& q) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < p.angle.size(); ++k)
    points.push_back({p.angle[k], std::clamp((p.*q.values)[k], q.low, q.high)});
  return points;
}

double end_of(const std::vector<Passage>& passages) {
  double end = 0.0;
  for (const Passage& p : passages) end = std::max(end, p.angle.back());
  return end;
}

std::vector<Curve> curves_of(Picture& picture, const std::vector<Passage>& passages, const char* formulation,
                             const Quantity& quantity) {
  std::vector<Curve> curves;
  for (int k = 0; k < static_cast<int>(integrators.size()); ++k)
    for (const Passage& p : passages) {
      if (p.formulation != formulation || p.integrator != integrators[k]) continue;
      const auto points = points_of(p, quantity);
      curves.push_back({picture.data(points), "with lines " + line_of(k)});
      if (p.angle.back() < end_of(passages)) curves.push_back({picture.data({points.back()}), cross});
    }
  return curves;
}

void draw_legend(Picture& picture) {
  std::vector<Curve> curves;
  for (int k = 0; k < static_cast<int>(integrators.size()); ++k)
    curves.push_back({"", "with lines " + line_of(k), integrators[k]});
  curves.push_back({"", cross, "the run ended"});
  picture.legend({0.05, 0.95, 0.905, 0.945}, curves, 6);
}

void draw_panel(Picture& picture, const std::vector<Passage>& passages, std::size_t row, std::size_t column) {
  const Quantity& q = quantities[row];
  const bool left = column == 0, lowest = row + 1 == quantities.size();
  picture.command(fmt::format("set yrange [{}:{}]; set ylabel {}; set format y {}", q.low, q.high,
                              left ? quote(q.label) : "''", left ? "'1e%T'" : "''"));
  picture.command(lowest ? "set xlabel 'crank angle [degrees]'; unset title"
                         : "unset xlabel; set title " + quote(formulations[column]) +
                               " noenhanced offset 0,-0.6");
  const double x = 0.065 + 0.233 * static_cast<double>(column), y = lowest ? 0.12 : 0.51;
  picture.panel({x, x + 0.215, y, y + 0.35});
  picture.plot(curves_of(picture, passages, formulations[column], q));
}

}  // namespace

std::vector<Passage> read_passages(const std::filesystem::path& file) {
  const auto table =
      CsvTable::read(file, {"formulation", "integrator", "exact_angle", "tilt", "angle_error"});
  std::vector<Passage> passages;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    const std::string &formulation = row.text("formulation"), &integrator = row.text("integrator");
    if (passages.empty() || passages.back().formulation != formulation ||
        passages.back().integrator != integrator)
      passages.push_back({formulation, integrator, {}, {}, {}});
    passages.back().angle.push_back(row.number("exact_angle") * 180.0 / std::numbers::pi);
    passages.back().tilt.push_back(row.number("tilt"));
    passages.back().angle_error.push_back(std::abs(row.number("angle_error")));
  }
  return passages;
}

Picture flat_position_chart(const std::vector<Passage>& passages, const std::vector<std::string>& caption) {
  if (passages.empty()) throw Error(ErrorCode::input_output, "four_bar_traces.csv has no rows");
  Picture picture("four_bar_flat", 1300, 800);
  picture.title("The linkage of two loops through its flat position (90 and 270 degrees), h = 1.25 ms");
  picture.caption(caption);
  draw_legend(picture);
  picture.command(grid_command);
  picture.command(fmt::format("set logscale y; set ytics 1e3; unset mytics; set xtics 90; set xrange [50:{}]",
                              end_of(passages)));
  for (std::size_t row = 0; row < quantities.size(); ++row)
    for (std::size_t column = 0; column < formulations.size(); ++column)
      draw_panel(picture, passages, row, column);
  return picture;
}

}  // namespace tandem::charts
