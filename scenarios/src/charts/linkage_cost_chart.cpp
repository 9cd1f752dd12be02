// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/linkage_cost_chart.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

struct Look {
  const char *solver, *colour, *dashes;
  int marker;  // gnuplot's point type
  double width;
};
/// Ours and what they are measured against in strong lines, on top of the others.
constexpr std::array<Look, 16> looks = {{{"lapack", "#009E73", "1", 4, 1.1},
                                         {"lapack_lu", "#009E73", "'-'", 6, 1.1},
                                         {"eigen_dense", "#009E73", "'.'", 8, 1.1},
                                         {"lapack_band", "#0072B2", "'-'", 4, 1.1},
                                         {"umfpack", "#A0A0A0", "1", 4, 1.1},
                                         {"superlu", "#A0A0A0", "'-'", 6, 1.1},
                                         {"mumps", "#A0A0A0", "'.'", 8, 1.1},
                                         {"cholmod", "#E69F00", "1", 4, 1.1},
                                         {"cholmod_supernodal", "#E69F00", "'-'", 6, 1.1},
                                         {"ldlt", "#E69F00", "'.'", 8, 1.1},
                                         {"klu_full", "#A0307A", "'-'", 6, 1.1},
                                         {"klu", "#A0307A", "1", 7, 1.6},
                                         {"prepared", "#56B4E9", "1", 9, 1.6},
                                         {"generic", "#D55E00", "1", 13, 2.2},
                                         {"band", "#0072B2", "1", 5, 2.2},
                                         {"auto", "#000000", "1", 7, 2.2}}};

std::string style_of(const Look& l) {
  return fmt::format("with linespoints lc rgb '{}' lw {} dt {} pt {} ps 0.6", l.colour, l.width, l.dashes,
                     l.marker);
}

using Times = std::vector<LinkageTime>;

/// per_variable: [ns] of a variable; else [us] of the step.
std::vector<Point> points_of(const Times& times, const std::string& solver, bool per_variable) {
  std::vector<Point> points;
  for (const LinkageTime& t : times)
    if (t.solver == solver) points.push_back({t.variables, per_variable ? t.ns : 1e-3 * t.ns * t.variables});
  return points;
}

std::vector<Curve> curves_of(Picture& picture, const Times& times, bool per_variable) {
  std::vector<Curve> curves;
  for (const Look& look : looks) {
    const auto points = points_of(times, look.solver, per_variable);
    if (!points.empty()) curves.push_back({picture.data(points), style_of(look), look.solver});
  }
  return curves;
}

Times shown(const Times& all) {
  Times times;
  for (const LinkageTime& t : all)
    if (t.step == 1.25e-3 && t.tolerance == 1e-5 && std::isfinite(t.ns)) times.push_back(t);
  if (times.empty())
    throw Error(ErrorCode::input_output, "four_bar.csv has no row of step 1.25e-3 s and 1e-5 m");
  return times;
}

/// Through the last point of `auto`, with slope 1.
Curve guide(const Times& times) {
  double ns = 0.0;
  for (const LinkageTime& t : times)
    if (t.solver == "auto") ns = t.ns;
  return {fmt::format("{}*x", 1e-3 * ns), "with lines lc rgb '#808080' lw 1 dt '.'"};
}

}  // namespace

std::vector<LinkageTime> read_linkage_times(const std::filesystem::path& file) {
  const auto table =
      CsvTable::read(file, {"solver", "variables", "step", "newton_tolerance", "ns_per_step_variable"});
  Times times;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    times.push_back({row.text("solver"), row.positive("variables"), row.positive("step"),
                     row.positive("newton_tolerance"), row.number("ns_per_step_variable")});
  }
  return times;
}

Picture linkage_cost_chart(const Times& all, const std::vector<std::string>& caption) {
  const Times times = shown(all);
  Picture picture("four_bar_cost", 1200, 640);
  picture.title("Cost of a step of the N-fold four-bar linkage, h = 1.25 ms, Newton tolerance 1e-5 m");
  picture.caption(caption);
  auto curves = curves_of(picture, times, false);
  const auto per_variable = curves_of(picture, times, true);
  picture.legend({0.03, 0.97, 0.855, 0.945}, {per_variable.rbegin(), per_variable.rend()}, 6);
  picture.command(grid_command);
  picture.command(
      "set logscale xy; set xrange [3:12000]; set xlabel 'variables'; unset key; set format y '%g'");
  for (Curve& c : curves) c.title.clear();
  curves.insert(curves.begin(), guide(times));
  picture.command(
      "set ylabel 'time of a step [us]'; set title 'dotted: in proportion to the variables' offset 0,-0.6");
  picture.panel({0.095, 0.48, 0.17, 0.81});
  picture.plot(curves);
  picture.command("set ylabel 'time of a step and variable [ns]'; unset title");
  picture.panel({0.585, 0.975, 0.17, 0.81});
  picture.plot(per_variable);
  return picture;
}

}  // namespace tandem::charts
