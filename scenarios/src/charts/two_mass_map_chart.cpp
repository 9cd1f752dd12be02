// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "charts/style.hpp"
#include "charts/two_mass_best.hpp"
#include "charts/two_mass_charts.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

/// Cells with an error up to the limit: the smaller the darker, in grey too. Larger errors have no shade.
struct Shade {
  double limit;
  const char* colour;
};
constexpr std::array<Shade, 5> shades = {{{0.01, "#08306B"},
                                          {0.02, "#2A70B0"},
                                          {0.05, "#6BAED6"},
                                          {best_limit, "#B5D4EA"},
                                          {failure_limit, "#E6E6E6"}}};

std::string style_of(const Shade& shade) {
  return fmt::format("using 1:2:(0.5):(0.5) with boxxyerror fs solid 1 border rgb 'white' lc rgb '{}'",
                     shade.colour);
}

/// What stands in a cell.
enum class Sign { amplified, damped, failed, disc, best, best_without_matched_hold };
struct SignStyle {
  Sign sign;
  const char* style;
  std::string title;
};
const std::array<SignStyle, 6> signs = {
    {{Sign::amplified, "with points pt 8 ps 0.55 lw 1 lc rgb '#707070'", "fast mode amplified > 10 %"},
     {Sign::damped, "with points pt 11 ps 0.55 lc rgb '#707070'", "fast mode damped > 10 %"},
     {Sign::failed, "with points pt 2 ps 0.45 lw 1 lc rgb '#707070'", "failed, or above 50 %"},
     {Sign::disc, "with points pt 7 ps 0.95 lc rgb 'white'", ""},
     {Sign::best, "with points pt 7 ps 0.6 lc rgb '#000000'", "best"},
     {Sign::best_without_matched_hold, "with points pt 6 ps 0.6 lw 1.8 lc rgb '#000000'",
      "best without matched hold"}}};

int order_of(const std::string& schedule) {
  const char* const order[] = {"slowest-first", "fastest-first", "staggered", "parallel"};
  return static_cast<int>(std::find(std::begin(order), std::end(order), schedule) - std::begin(order));
}

/// The schemes, schedule by schedule, otherwise in the order of the table.
std::vector<Scheme> schemes_of(const std::vector<Result>& sweep) {
  std::vector<Scheme> schemes;
  for (const Result& r : sweep)
    if (std::find(schemes.begin(), schemes.end(), r.scheme) == schemes.end()) schemes.push_back(r.scheme);
  std::stable_sort(schemes.begin(), schemes.end(), [](const Scheme& a, const Scheme& b) {
    return order_of(a.schedule) < order_of(b.schedule);
  });
  return schemes;
}

/// One row for each scheme, one column for each frequency ratio.
class SchemeMap {
 public:
  explicit SchemeMap(const std::vector<Result>& sweep) : schemes_(schemes_of(sweep)) {
    std::set<double> ratios;
    for (const Result& r : sweep) ratios.insert(r.frequency_ratio);
    ratios_.assign(ratios.begin(), ratios.end());
    for (const Result& r : sweep) add(r);
    std::vector<Result> others = sweep;
    std::erase_if(others, [](const Result& r) { return r.scheme.to_fast == "matched_hold"; });
    for (const double ratio : ratios_) mark_best(best_at(sweep, ratio), best_at(others, ratio));
  }

  /// The axes: a scheme's row has its name, a column its ratio; a gap stands between schedules.
  void set_axes(Picture& picture) const {
    std::string columns, rows;
    for (std::size_t k = 0; k < ratios_.size(); ++k)
      columns += fmt::format("{}'{}' {}", k == 0 ? "" : ", ", ratios_[k], k);
    for (const Scheme& s : schemes_)
      rows += (rows.empty() ? "" : ", ") + quote(name_of(s)) + fmt::format(" {}", row_of(s));
    picture.command(fmt::format(
        "set xrange [-0.7:{}]; set yrange [{}:-0.7]; set xtics ({}) rotate by 90 right out nomirror",
        static_cast<double>(ratios_.size()) - 0.3, row_of(schemes_.back()) + 0.7, columns));
    picture.command("set ytics (" + rows +
                    ") noenhanced out nomirror; set xlabel 'frequency ratio' offset 0,0.3; unset grid");
  }

  std::vector<Curve> curves(Picture& picture) const {
    std::vector<Curve> curves;
    for (std::size_t k = 0; k < shades.size(); ++k)
      curves.push_back({picture.data(cells_[k]), style_of(shades[k])});
    for (const SignStyle& s : signs)
      if (const auto found = signs_.find(s.sign); found != signs_.end())
        curves.push_back({picture.data(found->second), s.style});
    return curves;
  }

 private:
  double row_of(const Scheme& scheme) const {
    const auto found = std::find(schemes_.begin(), schemes_.end(), scheme);
    return static_cast<double>(found - schemes_.begin()) + 0.5 * order_of(scheme.schedule);
  }

  Point place_of(const Result& r) const {
    const auto column = std::lower_bound(ratios_.begin(), ratios_.end(), r.frequency_ratio);
    return {static_cast<double>(column - ratios_.begin()), row_of(r.scheme)};
  }

  void add(const Result& r) {
    const auto shade =
        std::find_if(shades.begin(), shades.end(), [&](const Shade& s) { return r.error() <= s.limit; });
    if (shade != shades.end())
      cells_[static_cast<std::size_t>(shade - shades.begin())].push_back(place_of(r));
    if (!r.failed && std::abs(r.amplitude_error) > best_limit)
      signs_[r.amplitude_error > 0.0 ? Sign::amplified : Sign::damped].push_back(place_of(r));
    else if (shade == shades.end())
      signs_[Sign::failed].push_back(place_of(r));
  }

  void mark_best(const Result* best, const Result* without_matched_hold) {
    for (const Result* r : {best, without_matched_hold})
      if (r != nullptr) signs_[Sign::disc].push_back(place_of(*r));
    if (best != nullptr) signs_[Sign::best].push_back(place_of(*best));
    if (without_matched_hold != nullptr && without_matched_hold->scheme != best->scheme)
      signs_[Sign::best_without_matched_hold].push_back(place_of(*without_matched_hold));
  }

  std::vector<Scheme> schemes_;
  std::vector<double> ratios_;
  std::array<std::vector<Point>, shades.size()> cells_;
  std::map<Sign, std::vector<Point>> signs_;
};

void draw_legends(Picture& picture) {
  std::vector<Curve> shade_curves, sign_curves;
  for (const Shade& s : shades)
    shade_curves.push_back({"", fmt::format("with points pt 5 ps 1.4 lc rgb '{}'", s.colour),
                            fmt::format("up to {:g} %", 100.0 * s.limit)});
  for (const SignStyle& s : signs)
    if (!s.title.empty()) sign_curves.push_back({"", s.style, s.title});
  picture.legend({0.05, 0.95, 0.947, 0.969}, shade_curves, 5);
  picture.legend({0.02, 0.98, 0.906, 0.942}, sign_curves, 5);
}

}  // namespace

Picture best_scheme_chart(const std::vector<Result>& sweep, const Caption& caption) {
  std::vector<Result> results = sweep;
  std::erase_if(results, [](const Result& r) { return !compared(r.scheme); });
  if (results.empty())
    throw Error(ErrorCode::input_output, "sweep.csv has no scheme with equal reconstructions both ways");
  const SchemeMap map(results);
  Picture picture("best_scheme", 1300, 1000);
  picture.title("Error of each scheme at each frequency ratio, and the best scheme");
  Caption lines = {
      fmt::format("Error: the larger of position error and amplitude error of the fast mode. Best: the "
                  "smallest error, none "
                  "if above {:g} %.",
                  100.0 * best_limit)};
  lines.insert(lines.end(), caption.begin(), caption.end());
  picture.caption(lines);
  draw_legends(picture);
  map.set_axes(picture);
  picture.panel({0.23, 0.985, 0.15, 0.9});
  picture.plot(map.curves(picture));
  return picture;
}

}  // namespace tandem::charts
