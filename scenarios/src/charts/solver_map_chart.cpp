// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/solver_map_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

struct Letter {
  const char *solver, *letter, *colour;
};
constexpr std::array<Letter, 14> letters = {{{"band", "B", "#000000"},
                                             {"prepared", "P", "#D55E00"},
                                             {"lapack_band", "N", "#0072B2"},
                                             {"lapack", "L", "#009E73"},
                                             {"lapack_lu", "G", "#009E73"},
                                             {"eigen_dense", "E", "#8A6D00"},
                                             {"klu", "K", "#A0307A"},
                                             {"klu_full", "F", "#A0307A"},
                                             {"mumps", "M", "#C00000"},
                                             {"umfpack", "U", "#C00000"},
                                             {"superlu", "W", "#C00000"},
                                             {"cholmod", "C", "#505050"},
                                             {"cholmod_supernodal", "S", "#505050"},
                                             {"ldlt", "D", "#505050"}}};

struct Shade {
  double above;
  const char* colour;
};
constexpr std::array<Shade, 3> shades = {{{1.2, "#E8E8E8"}, {1.5, "#C8C8C8"}, {2.0, "#9A9A9A"}}};

struct Panel {
  const char *kind, *placement;
  bool rough;
  const char* title;
};
constexpr std::array<Panel, 10> panels = {
    {{"positive definite", "near", false, "positive definite, near the diagonal"},
     {"positive definite", "anywhere", false, "positive definite, anywhere"},
     {"symmetric", "near", false, "symmetric, near, smooth"},
     {"symmetric", "anywhere", false, "symmetric, anywhere, smooth"},
     {"symmetric", "near", true, "symmetric, near, rough"},
     {"symmetric", "anywhere", true, "symmetric, anywhere, rough"},
     {"unsymmetric", "near", false, "unsymmetric, near, smooth"},
     {"unsymmetric", "anywhere", false, "unsymmetric, anywhere, smooth"},
     {"unsymmetric", "near", true, "unsymmetric, near, rough"},
     {"unsymmetric", "anywhere", true, "unsymmetric, anywhere, rough"}}};

constexpr double frame_above = 1.5;  ///< times the best: the thesis' rule differs there
constexpr double cell = 1.26;        ///< half a cell as a factor on either axis

std::vector<Curve> curves_of(Picture& picture, const std::vector<SolverTime>& times, const Panel& panel) {
  std::map<std::string, std::vector<Point>> best;
  std::array<std::vector<Point>, shades.size()> behind;
  std::vector<Point> frames;
  for (const SolverTime& t : times) {
    if (t.kind != panel.kind || t.placement != panel.placement) continue;
    const double over = panel.rough ? t.over_rough : t.over_smooth;
    const Point place{t.variables, t.filling};
    if (t.solver == "thesis") {
      if (over > frame_above) frames.push_back(place);
      continue;
    }
    if (t.solver != "auto") {
      if (over == 1.0) best[t.solver].push_back(place);
      continue;
    }
    for (std::size_t k = shades.size(); k-- > 0;)
      if (over > shades[k].above) {
        behind[k].push_back(place);
        break;
      }
  }
  std::vector<Curve> curves;
  for (std::size_t k = 0; k < shades.size(); ++k)
    curves.push_back({picture.data(behind[k]),
                      fmt::format("using 1:2:($1/{0}):($1*{0}):($2/{0}):($2*{0}) with boxxyerror fs solid 1 "
                                  "noborder lc rgb '{1}'",
                                  cell, shades[k].colour)});
  curves.push_back(
      {picture.data(frames),
       fmt::format("using 1:2:($1/{0}):($1*{0}):($2/{0}):($2*{0}) with boxxyerror fs empty lc rgb '#0072B2'",
                   0.98 * cell)});
  for (const Letter& l : letters)
    if (best.contains(l.solver))
      curves.push_back({picture.data(best[l.solver]),
                        fmt::format("with points pt '{}' ps 1 lc rgb '{}'", l.letter, l.colour)});
  return curves;
}

void draw_legends(Picture& picture, const std::vector<SolverTime>& times) {
  std::set<std::string> winners;
  for (const SolverTime& t : times)
    if (t.solver != "auto" && t.solver != "thesis" && (t.over_smooth == 1.0 || t.over_rough == 1.0))
      winners.insert(t.solver);
  std::vector<Curve> solvers, behind;
  for (const Letter& l : letters)
    if (winners.contains(l.solver))
      solvers.push_back({"", fmt::format("with points pt '{}' lc rgb '{}'", l.letter, l.colour), l.solver});
  for (const Shade& s : shades)
    behind.push_back({"", fmt::format("with points pt 5 ps 1.4 lc rgb '{}'", s.colour),
                      fmt::format("auto takes over {:g} times as long", s.above)});
  picture.legend({0.03, 0.97, 0.935, 0.968}, solvers, 6);
  behind.push_back({"", "with points pt 4 ps 1.4 lc rgb '#0072B2'",
                    fmt::format("the thesis\' rule over {:g} times", frame_above)});
  picture.legend({0.03, 0.97, 0.908, 0.925}, behind, 4);
}

}  // namespace

std::vector<SolverTime> read_solver_times(const std::filesystem::path& file) {
  const auto table = CsvTable::read(
      file, {"kind", "placement", "variables", "filling", "solver", "over_best_smooth", "over_best_rough"});
  std::vector<SolverTime> times;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    times.push_back({row.text("kind"), row.text("placement"), row.text("solver"), row.positive("variables"),
                     row.positive("filling"), row.number("over_best_smooth"), row.number("over_best_rough")});
  }
  return times;
}

Picture solver_map_chart(const std::vector<SolverTime>& times, const std::vector<std::string>& caption) {
  if (times.empty()) throw Error(ErrorCode::input_output, "solvers.csv has no rows");
  constexpr std::size_t rows = panels.size() / 2;
  Picture picture("solvers", 1100, 1500);
  picture.title("The solver with the least time for a factorization and two solutions");
  picture.caption(caption);
  draw_legends(picture, times);
  picture.command("set logscale xy; set xrange [7:12000]; set yrange [4:150]; unset key");
  picture.command("set ytics (6, 12, 25, 50, 100); set xtics (10, 100, 1000, 10000)");
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const std::size_t row = k / 2;
    const bool left = k % 2 == 0;
    const double height = 0.83 / rows, top = 0.895 - static_cast<double>(row) * height;
    picture.command(fmt::format("set title {} offset 0,-0.7 noenhanced", quote(panels[k].title)));
    picture.command(left ? "set ylabel 'entries a row'" : "unset ylabel");
    picture.command(row + 1 == rows ? "set xlabel 'variables'" : "unset xlabel");
    picture.panel({left ? 0.07 : 0.55, left ? 0.5 : 0.98, top - height + 0.035, top - 0.012});
    picture.plot(curves_of(picture, times, panels[k]));
  }
  return picture;
}

}  // namespace tandem::charts
