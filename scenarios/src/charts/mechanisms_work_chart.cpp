// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/mechanisms_work_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

using Works = std::vector<FormulationWork>;

struct Formulation {
  const char *name, *colour;
};
struct Integrator {
  const char *name, *dashes;
  int marker;  // gnuplot's point type
};
constexpr std::array<Formulation, 4> formulations = {
    {{"index3", "#000000"}, {"penalty", "#E69F00"}, {"index1", "#0072B2"}, {"null_space", "#009E73"}}};
constexpr std::array<Integrator, 5> integrators = {{{"newmark", "1", 7},
                                                    {"rk2", "'-'", 9},
                                                    {"rk4", "1", 5},
                                                    {"rk8", "'_'", 11},
                                                    {"generalized_alpha", "'.'", 13}}};
constexpr std::size_t columns = 4;

std::string style_of(const Formulation& f, const Integrator& i) {
  return fmt::format("with linespoints lc rgb '{}' lw 1.3 dt {} pt {} ps 0.6", f.colour, i.dashes, i.marker);
}

/// In the order of the file.
std::vector<std::string> mechanisms_of(const Works& work) {
  std::vector<std::string> names;
  for (const FormulationWork& w : work)
    if (std::find(names.begin(), names.end(), w.mechanism) == names.end()) names.push_back(w.mechanism);
  return names;
}

std::vector<Point> points_of(const Works& runs, const Integrator& i) {
  std::vector<Point> points;
  for (const FormulationWork& w : runs)
    if (w.integrator == i.name && w.error > 0.0) points.push_back({1e3 * w.seconds, w.error});
  return points;
}

Works only(const Works& work, const std::string& mechanism, const Formulation& f) {
  Works runs;
  for (const FormulationWork& w : work)
    if (w.mechanism == mechanism && w.formulation == f.name) runs.push_back(w);
  return runs;
}

std::vector<Curve> curves_of(Picture& picture, const Works& work, const std::string& mechanism) {
  std::vector<Curve> curves;
  for (const Formulation& f : formulations)
    for (const Integrator& i : integrators)
      if (const auto points = points_of(only(work, mechanism, f), i); !points.empty())
        curves.push_back({picture.data(points), style_of(f, i)});
  return curves;
}

/// Which formulations failed with every step, and with how many integrators.
std::string failures(const Works& work, const std::string& mechanism) {
  std::string text;
  for (const Formulation& f : formulations) {
    const Works runs = only(work, mechanism, f);
    std::set<std::string> all, ran;
    for (const FormulationWork& w : runs) {
      all.insert(w.integrator);
      if (w.error > 0.0) ran.insert(w.integrator);
    }
    if (ran.size() < all.size())
      text += fmt::format("{}{} failed with {} of {}", text.empty() ? "" : ", ", f.name,
                          all.size() - ran.size(), all.size());
  }
  return text;
}

/// The same for all panels.
void set_time_axis(Picture& picture, const Works& work) {
  double least = INFINITY, most = 0.0;
  for (const FormulationWork& w : work)
    if (w.error > 0.0) least = std::min(least, 1e3 * w.seconds), most = std::max(most, 1e3 * w.seconds);
  if (most > 0.0) picture.command(fmt::format("set xrange [{:.3g}:{:.3g}]", least / 1.5, 1.5 * most));
}

void draw_legends(Picture& picture) {
  std::vector<Curve> by_colour, by_marker;
  for (const Formulation& f : formulations)
    by_colour.push_back({"", fmt::format("with lines lw 3 lc rgb '{}'", f.colour), f.name});
  for (const Integrator& i : integrators) by_marker.push_back({"", style_of({"", "#606060"}, i), i.name});
  picture.legend({0.05, 0.95, 0.945, 0.965}, by_colour, 4);
  picture.legend({0.05, 0.95, 0.92, 0.94}, by_marker, 5);
}

void draw(Picture& picture, const Works& work, const std::string& mechanism, const Box& box) {
  const auto curves = curves_of(picture, work, mechanism);
  const std::string failed = failures(work, mechanism);
  picture.command(fmt::format("set title {} noenhanced offset 0,-0.7", quote(mechanism)));
  picture.command(fmt::format(
      "set label 98 {} at graph 0.03,0.06 left noenhanced font small tc rgb '#D55E00'", quote(failed)));
  picture.panel(box);
  picture.plot(curves.empty() ? std::vector<Curve>{{"NaN", "with lines"}} : curves);
}

}  // namespace

Works read_formulation_work(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file, {"mechanism", "formulation", "integrator", "error", "seconds"});
  Works work;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    work.push_back({row.text("mechanism"), row.text("formulation"), row.text("integrator"),
                    row.number("error"), row.number("seconds")});
  }
  return work;
}

Picture mechanisms_work_chart(const Works& work, const std::vector<std::string>& caption) {
  const auto names = mechanisms_of(work);
  if (names.empty()) throw Error(ErrorCode::input_output, "work.csv has no rows");
  const std::size_t rows = (names.size() + columns - 1) / columns;
  Picture picture("mechanisms", 1400, 120 + 300 * static_cast<int>(rows));
  picture.title("Error against processor time: each formulation with each integrator, four steps, by halves");
  picture.caption(caption);
  draw_legends(picture);
  picture.command(std::string(grid_command) + "; unset key");
  picture.command("set logscale xy; set format y '1e%T'; set format x '%g'; set xtics 10; set ytics 100");
  set_time_axis(picture, work);
  const double width = 0.955 / columns, height = 0.86 / static_cast<double>(rows);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::size_t row = k / columns, column = k % columns;
    const double left = 0.075 + static_cast<double>(column) * width,
                 top = 0.895 - static_cast<double>(row) * height;
    picture.command(column == 0 ? "set ylabel 'error [m or rad]'" : "unset ylabel");
    picture.command(k + columns >= names.size() ? "set xlabel 'processor time [ms]'" : "unset xlabel");
    draw(picture, work, names[k], {left, left + width - 0.04, top - height + 0.06, top});
  }
  return picture;
}

}  // namespace tandem::charts
