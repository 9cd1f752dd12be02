// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "charts/error_axis.hpp"
#include "charts/style.hpp"
#include "charts/two_mass_best.hpp"
#include "charts/two_mass_charts.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

constexpr int degrees = 5;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct Quantity {
  double Result::*value;
  const char* label;
};

using Selection = std::vector<const Result*>;

Selection select(const std::vector<Result>& sweep, const std::string& schedule, int degree) {
  Selection selection;
  for (const Result& r : sweep)
    if (r.scheme.schedule == schedule && equal_degree(r.scheme) == degree) selection.push_back(&r);
  std::sort(selection.begin(), selection.end(),
            [](const Result* a, const Result* b) { return a->frequency_ratio < b->frequency_ratio; });
  if (selection.empty())
    throw Error(ErrorCode::input_output,
                fmt::format("sweep.csv has no row with schedule {}, lagrange{} both ways", schedule, degree));
  return selection;
}

double smallest(const std::vector<Result>& sweep, double Result::*value) {
  double least = failure_limit;
  for (const Result& r : sweep)
    if (equal_degree(r.scheme) >= 0 && !r.failed && r.*value > 0.0) least = std::min(least, r.*value);
  return least;
}

bool sound(const Result& r) { return std::abs(r.amplitude_error) <= best_limit; }

/// One degree: its line, interrupted at failures, its markers, and its failures on the strip.
class DegreeCurves {
 public:
  DegreeCurves(const Selection& selection, double Result::*value, const ErrorAxis& axis, int degree)
      : degree_(degree) {
    for (const Result* r : selection) {
      const double error = r->*value;
      const bool shown = !r->failed && axis.shows(error);
      const Point point{r->frequency_ratio, axis.place(error)};
      line_.push_back(shown ? point : Point{r->frequency_ratio, nothing});
      if (shown) (sound(*r) ? filled_ : hollow_).push_back(point);
      if (!shown) failures_.push_back({r->frequency_ratio, axis.strip(degree)});
    }
  }

  void add_to(std::vector<Curve>& curves, Picture& picture) const {
    const std::string hollow = picture.data(hollow_), failures = picture.data(failures_);
    curves.push_back({picture.data(line_), "with lines " + line_of(degree_)});
    curves.push_back({picture.data(filled_), "with points " + marker_of(degree_)});
    curves.push_back({hollow, "with points " + white_marker_of(degree_)});
    curves.push_back({hollow, "with points " + hollow_marker_of(degree_)});
    curves.push_back({failures, "with points " + marker_of(degree_)});
  }

 private:
  int degree_;
  std::vector<Point> line_, filled_, hollow_, failures_;
};

void set_ratio_axis(Picture& picture, const std::vector<Result>& sweep) {
  const auto [low, high] = std::minmax_element(
      sweep.begin(), sweep.end(),
      [](const Result& a, const Result& b) { return a.frequency_ratio < b.frequency_ratio; });
  picture.command(
      fmt::format("set logscale x; set xrange [{}:{}]; set xtics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)",
                  low->frequency_ratio / 1.15, 1.15 * high->frequency_ratio));
}

void draw_panel(Picture& picture, const std::vector<Result>& sweep, const std::string& schedule,
                const Quantity& quantity) {
  const ErrorAxis axis(smallest(sweep, quantity.value), degrees);
  std::vector<Curve> curves;
  for (int degree = 0; degree < degrees; ++degree)
    DegreeCurves(select(sweep, schedule, degree), quantity.value, axis, degree).add_to(curves, picture);
  axis.apply(picture, quantity.label, "failed, or above 50 %");
  set_ratio_axis(picture, sweep);
  picture.command(std::string(grid_command) + "; set title " + quote(schedule) + " offset 0,-0.5");
  picture.plot(curves);
  ErrorAxis::end(picture);
}

std::vector<Curve> legend() {
  std::vector<Curve> curves;
  for (int k = 0; k < degrees; ++k)
    curves.push_back({"", "with linespoints " + line_and_marker_of(k), fmt::format("degree {}", k)});
  return curves;
}

}  // namespace

Picture errors_chart(const std::vector<Result>& sweep, const Caption& caption) {
  Picture picture("errors", 1200, 1000);
  picture.title("Two-mass three-spring test: Lagrange polynomials of equal degree both ways");
  Caption lines = {
      fmt::format("Hollow marker: the amplitude of the fast mode is off by more than {:g} % or not to be "
                  "found, so a small error is false.",
                  100.0 * best_limit)};
  lines.insert(lines.end(), caption.begin(), caption.end());
  picture.caption(lines);
  picture.legend({0.05, 0.98, 0.92, 0.96}, legend(), degrees);
  const Quantity position{&Result::position_error, "position error [%]"},
      energy{&Result::energy_error, "energy error [%]"};
  picture.panel({0.07, 0.485, 0.55, 0.89});
  draw_panel(picture, sweep, "slowest-first", position);
  picture.panel({0.575, 0.99, 0.55, 0.89});
  draw_panel(picture, sweep, "fastest-first", position);
  picture.command("set xlabel 'frequency ratio'");
  picture.panel({0.07, 0.485, 0.125, 0.48});
  draw_panel(picture, sweep, "slowest-first", energy);
  picture.panel({0.575, 0.99, 0.125, 0.48});
  draw_panel(picture, sweep, "fastest-first", energy);
  return picture;
}

}  // namespace tandem::charts
