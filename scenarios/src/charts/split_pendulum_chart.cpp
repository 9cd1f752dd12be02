// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/split_pendulum_chart.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

using Schemes = std::vector<SplitPendulumScheme>;

constexpr std::array schedules = {"slowest-first", "fastest-first", "parallel"};
constexpr double top = 1.0;  // [m], where crosses stand: above any error that is not lost

struct Displacement {
  const char *to_lower, *tic;
};
constexpr std::array<Displacement, 11> displacements = {{{"lagrange2", "degree 2"},
                                                         {"lagrange3", "3"},
                                                         {"lagrange4", "4"},
                                                         {"hermite", "hermite"},
                                                         {"least_squares1_2", "least sq. 1+2"},
                                                         {"least_squares1_4", "1+4"},
                                                         {"least_squares2_2", "2+2"},
                                                         {"least_squares2_4", "2+4"},
                                                         {"least_squares3_2", "3+2"},
                                                         {"least_squares3_4", "3+4"},
                                                         {"matched_hold", "hold"}}};

struct Force {
  const char *name, *to_upper, *lag, *colour;
  int marker;  // gnuplot's point type
};
constexpr std::array<Force, 8> forces = {{{"force held", "lagrange0", "none", "#000000", 7},
                                          {"of degree 1", "lagrange1", "none", "#E69F00", 9},
                                          {"2", "lagrange2", "none", "#56B4E9", 5},
                                          {"3", "lagrange3", "none", "#D55E00", 13},
                                          {"4", "lagrange4", "none", "#0072B2", 11},
                                          {"mean", "mean", "none", "#009E73", 6},
                                          {"degree 1, late by a memory", "lagrange1", "memory", "#A0307A", 4},
                                          {"late by a delay", "lagrange1", "delay", "#8C6D31", 8}}};
constexpr double apart = 0.09;  // of two forces with one displacement

/// What the chart shows of all cases.
bool is_shown(const SplitPendulumScheme& s) {
  return s.formulation == "null_space" && s.fast == "lower" && s.lower_mass == 0.1 && s.ratio == 10.0;
}

struct Drawn {
  std::vector<Point> errors, failures;
};

/// Matched hold stands with the force that is held.
bool is_given_by(const SplitPendulumScheme& s, const Force& force) {
  const bool holds = s.to_upper == "matched_hold" && force.to_upper == std::string("lagrange0");
  return s.lag == force.lag && (s.to_upper == force.to_upper || holds);
}

Drawn points_of(const Schemes& panel, const Force& force, double beside) {
  Drawn drawn;
  for (std::size_t k = 0; k < displacements.size(); ++k)
    for (const auto& s : panel) {
      if (s.to_lower != displacements[k].to_lower || !is_given_by(s, force)) continue;
      const double x = static_cast<double>(k) + beside;
      std::isfinite(s.error) ? drawn.errors.push_back({x, s.error}) : drawn.failures.push_back({x, top});
    }
  return drawn;
}

std::string look(const Force& f) {
  return fmt::format("with points pt {} ps 0.9 lw 1.4 lc rgb '{}'", f.marker, f.colour);
}

std::vector<Curve> legend() {
  std::vector<Curve> curves;
  for (const Force& f : forces) curves.push_back({"", look(f), f.name});
  curves.push_back(
      {"", "with points pt 2 ps 1 lw 2 lc rgb '#808080'", "unstable or lost, each in its colour"});
  curves.push_back({"", "with lines dt 2 lw 1.6 lc rgb '#404040'", "in one mechanism"});
  return curves;
}

std::vector<Curve> curves_of(Picture& picture, const Schemes& panel, double monolithic) {
  const double last = static_cast<double>(displacements.size()) - 0.5;
  std::vector<Curve> curves = {
      {picture.data({{-0.5, monolithic}, {last, monolithic}}), "with lines dt 2 lw 1.6 lc rgb '#404040'"}};
  double beside = -apart * 0.5 * static_cast<double>(forces.size() - 1);
  for (const Force& force : forces) {
    const auto [errors, failures] = points_of(panel, force, beside);
    beside += apart;
    if (!errors.empty()) curves.push_back({picture.data(errors), look(force)});
    if (!failures.empty())
      curves.push_back(
          {picture.data(failures), fmt::format("with points pt 2 ps 1 lw 2 lc rgb '{}'", force.colour)});
  }
  return curves;
}

Schemes panel_of(const Schemes& all, const char* schedule, double carried) {
  Schemes some;
  for (const auto& s : all)
    if (is_shown(s) && s.schedule == schedule && s.carried_mass == carried) some.push_back(s);
  return some;
}

/// The same for all panels: below the least error.
void set_axes(Picture& picture, const Schemes& all) {
  double least = top;
  for (const auto& s : all)
    if (is_shown(s) && s.error < least) least = s.error;
  std::string tics;
  for (std::size_t k = 0; k < displacements.size(); ++k)
    tics += fmt::format("{}'{}' {}", k > 0 ? ", " : "", displacements[k].tic, k);
  picture.command("set logscale y; set format y '1e%T'");
  picture.command(
      fmt::format("set xrange [-0.5:{}.5]; set xtics ({}) rotate by 35 right; set yrange [{:.3g}:{}]",
                  displacements.size() - 1, tics, least / 2.0, 1.6 * top));
}

/// Of one mechanism, with 1 ms.
double monolithic_error(const Schemes& all) {
  for (const auto& s : all)
    if (s.schedule == "monolithic" && s.formulation == "null_space" && s.lower_mass == 0.1) return s.error;
  throw Error(ErrorCode::input_output, "schemes.csv has no row of one mechanism");
}

}  // namespace

Schemes read_split_pendulum_schemes(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file, {"formulation", "carried_mass", "lower_mass", "fast", "ratio",
                                           "schedule", "to_lower", "to_upper", "lag", "largest_error"});
  Schemes schemes;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    schemes.push_back({row.text("formulation"), row.text("fast"), row.text("schedule"), row.text("to_lower"),
                       row.text("to_upper"), row.text("lag"), row.number("carried_mass"),
                       row.number("lower_mass"), row.number("ratio"), row.number("largest_error")});
  }
  return schemes;
}

Picture split_pendulum_chart(const Schemes& schemes, const std::vector<std::string>& caption) {
  const double monolithic = monolithic_error(schemes);
  Picture picture("split_pendulum", 1400, 900);
  picture.title(
      "A double pendulum split at its elbow: largest error in 2 s, steps of 1 ms above and 0.1 ms below");
  picture.caption(caption);
  picture.legend({0.04, 0.96, 0.88, 0.95}, legend(), 5);
  picture.command(std::string(grid_command) + "; unset key");
  set_axes(picture, schemes);
  for (std::size_t k = 0; k < 2 * schedules.size(); ++k) {
    const bool carries = k >= schedules.size();
    const std::size_t column = k % schedules.size();
    const double left = 0.065 + 0.315 * static_cast<double>(column), bottom_edge = carries ? 0.17 : 0.56;
    picture.command(fmt::format("set title '{}, {}' offset 0,-0.6", schedules[column],
                                carries ? "a quarter of the lower rod carried" : "nothing carried"));
    picture.command(column == 0 ? "set ylabel 'error [m]'" : "unset ylabel");
    picture.command(carries ? "set xlabel 'displacement (1+2: degree 1, 2 more samples)'" : "unset xlabel");
    picture.panel({left, left + 0.275, bottom_edge, bottom_edge + 0.28});
    picture.plot(curves_of(picture, panel_of(schemes, schedules[column], carries ? 0.025 : 0.0), monolithic));
  }
  return picture;
}

}  // namespace tandem::charts
