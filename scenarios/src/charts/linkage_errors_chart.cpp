// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/linkage_errors_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

using Errors = std::vector<LinkageError>;

constexpr double top = 4.0;    // [m], where crosses stand
constexpr double most = 2e-3;  // [m], what is asked of the error
constexpr const char* cross = "with points pt 2 ps 1.2 lw 2.5 lc rgb '#D55E00'";
constexpr std::array<double, 2> tolerances = {1e-5, 1e-10};

struct Selection {
  double LinkageError::*over;   ///< the axis
  double LinkageError::*fixed;  ///< the same for the whole curve
  double value, tolerance;
};

struct Panel {
  Box place, legend;
  std::vector<Curve> curves, names;
};

/// A solid line for the tolerance of 1e-10 m, a dotted one for 1e-5 m.
std::string style_of(int k, double tolerance) {
  return tolerance < 1e-6 ? fmt::format("with linespoints {} lw 1.6", marker_of(k))
                          : fmt::format("with linespoints {} dt '.'", hollow_marker_of(k));
}

void add(Picture& picture, const Errors& errors, const Selection& s, int k, Panel& panel) {
  std::vector<Point> results, crosses;
  for (const LinkageError& e : errors)
    if (e.*s.fixed == s.value && e.tolerance == s.tolerance) {
      const bool failed = !std::isfinite(e.x_error);
      (failed ? crosses : results).push_back({e.*s.over, failed ? top : std::min(e.x_error, top)});
    }
  std::sort(results.begin(), results.end(), [](Point a, Point b) { return a.x < b.x; });
  panel.curves.push_back({picture.data(results), style_of(k, s.tolerance)});
  if (!crosses.empty()) panel.curves.push_back({picture.data(crosses), cross});
}

Panel over_loops(Picture& picture, const Errors& errors) {
  Panel panel{{0.07, 0.485, 0.145, 0.84}, {0.05, 0.49, 0.88, 0.935}, {}, {}};
  int k = 0;
  for (const double step : {1.25e-3, 1e-3}) {
    for (const double tolerance : tolerances)
      add(picture, errors, {&LinkageError::loops, &LinkageError::step, step, tolerance}, k, panel);
    panel.names.push_back({"", style_of(k, 1e-10), fmt::format("h = {:g} ms", 1e3 * step)});
    ++k;
  }
  panel.names.push_back({"", cross, "not to the end"});
  return panel;
}

Panel over_step(Picture& picture, Errors errors) {
  Panel panel{{0.565, 0.98, 0.145, 0.84}, {0.51, 0.99, 0.88, 0.935}, {}, {}};
  for (LinkageError& e : errors) e.step *= 1e3;
  int k = 0;
  for (const double loops : {1.0, 2.0, 20.0, 500.0, 4000.0}) {
    for (const double tolerance : tolerances)
      add(picture, errors, {&LinkageError::step, &LinkageError::loops, loops, tolerance}, k, panel);
    panel.names.push_back(
        {"", style_of(k, 1e-10), fmt::format("{:g} loop{}", loops, loops > 1.0 ? "s" : "")});
    ++k;
  }
  panel.curves.push_back({"2e-3*(x/2.5)**2", "with lines lc rgb '#808080' lw 1 dt '-'"});
  panel.names.push_back({"", "with lines lc rgb '#808080' lw 1 dt '-'", "order 2"});
  return panel;
}

void draw(Picture& picture, Panel panel) {
  panel.curves.push_back({fmt::format("{}", most), "with lines lc rgb '#808080' lw 1"});
  picture.panel(panel.place);
  picture.plot(panel.curves);
}

}  // namespace

std::vector<LinkageError> read_linkage_errors(const std::filesystem::path& file) {
  const auto table =
      CsvTable::read(file, {"loops", "formulation", "settings", "step", "newton_tolerance", "x_error"});
  Errors errors;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    if (row.text("formulation") == "index3" && row.text("settings").empty())
      errors.push_back({row.positive("loops"), row.positive("step"), row.positive("newton_tolerance"),
                        row.number("x_error")});
  }
  return errors;
}

Picture linkage_errors_chart(const Errors& errors, const std::vector<std::string>& caption) {
  if (errors.empty()) throw Error(ErrorCode::input_output, "four_bar.csv has no row of index3");
  Picture picture("four_bar_errors", 1200, 700);
  picture.title(
      "Error of the N-fold four-bar linkage after 20 s. Solid: Newton tolerance 1e-10 m, dotted: 1e-5 m");
  picture.caption(caption);
  const Panel left = over_loops(picture, errors), right = over_step(picture, errors);
  picture.legend(left.legend, left.names, 3);
  picture.legend(right.legend, right.names, 3);
  picture.command(std::string(grid_command) + "; unset key");
  picture.command(fmt::format("set logscale xy; set yrange [2e-5:{}]; set format y '1e%T'", 1.5 * top));
  picture.command("set ylabel 'error of x [m]'; set xlabel 'loops'; set xrange [0.8:5000]");
  draw(picture, left);
  picture.command(
      "unset ylabel; set xlabel 'step [ms]'; set xrange [0.55:2.8]; set xtics (0.625, 1, 1.25, 2, 2.5)");
  draw(picture, right);
  return picture;
}

}  // namespace tandem::charts
