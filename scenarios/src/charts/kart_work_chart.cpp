// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "charts/kart_charts.hpp"
#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/style.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

std::string scheme_of(const KartWork& w) { return w.schedule + ", " + w.to_fast + ", " + w.to_slow; }

/// What a scheme looks like: samples of the torque with full lines, its mean with dashes.
std::string look(std::size_t k, const std::string& scheme) {
  constexpr const char* colours[] = {"#000000", "#E69F00", "#56B4E9", "#009E73", "#D55E00",
                                     "#0072B2", "#A0307A", "#707000", "#606060"};
  constexpr int points[] = {7, 9, 5, 11, 13};
  return fmt::format("with linespoints lc rgb '{}' lw 1.6 pt {} ps 0.7{}", colours[k % std::size(colours)],
                     points[k % std::size(points)], scheme.ends_with("mean") ? " dt '-'" : "");
}

template <class Key>
std::vector<std::string> distinct(const std::vector<KartWork>& work, Key key) {
  std::vector<std::string> names;
  for (const KartWork& w : work)
    if (std::find(names.begin(), names.end(), key(w)) == names.end()) names.push_back(key(w));
  return names;
}

/// By rising ratio; runs that are not ok interrupt the line.
std::vector<Point> points_of(const std::vector<KartWork>& work, const std::string& level,
                             const std::string& scheme) {
  std::vector<Point> points;
  for (const KartWork& w : work)
    if (w.level == level && scheme_of(w) == scheme) points.push_back({w.seconds, w.pitch_error});
  return points;
}

bool failed(const KartWork& w) { return std::isnan(w.pitch_error); }

/// The same axes for all panels; a panel in which all failed stays empty.
std::string ranges(const std::vector<KartWork>& work) {
  double left = INFINITY, right = 0.0, low = INFINITY, high = 0.0;
  for (const KartWork& w : work) {
    if (failed(w)) continue;
    left = std::min(left, w.seconds), right = std::max(right, w.seconds);
    low = std::min(low, w.pitch_error), high = std::max(high, w.pitch_error);
  }
  if (!(left < INFINITY)) throw Error(ErrorCode::input_output, "work.csv has no run that came to its end");
  return fmt::format("set xrange [{:.4g}:{:.4g}]; set yrange [{:.4g}:{:.4g}]", 0.8 * left, 1.25 * right,
                     0.8 * std::max(low, 1e-6), 1.25 * high);
}

/// Panels in up to two columns, a single row with taller ones; legend above, caption below. Heights in
/// pixels.
class Sheet {
 public:
  explicit Sheet(std::size_t panels)
      : columns_(panels > 1 ? 2 : 1), rows_((panels + 1) / 2), panel_(rows_ > 1 ? 270.0 : 420.0) {}
  int height() const {
    return static_cast<int>(above + below + panel_ * static_cast<double>(rows_) +
                            between * static_cast<double>(rows_ - 1));
  }
  Box legend() const { return {0.03, 0.97, part(height() - 126.0), part(height() - 45.0)}; }
  Box panel(std::size_t k) const {
    const std::size_t line = k / 2;
    const double left = k % 2 == 0 ? 0.07 : 0.56, width = columns_ > 1 ? 0.41 : 0.9,
                 top = height() - above - (panel_ + between) * static_cast<double>(line);
    return {left, left + width, part(top - panel_), part(top)};
  }

 private:
  static constexpr double above = 171.0, below = 117.0, between = 96.0;
  double part(double pixels) const { return pixels / height(); }
  std::size_t columns_, rows_;
  double panel_;
};

void draw_level(Picture& picture, const std::vector<KartWork>& work, const std::string& level,
                const std::vector<std::string>& schemes) {
  std::vector<Curve> curves;
  for (std::size_t k = 0; k < schemes.size(); ++k)
    if (const auto points = points_of(work, level, schemes[k]); !points.empty())
      curves.push_back({picture.data(points), look(k, schemes[k])});
  const auto failures = std::count_if(work.begin(), work.end(),
                                      [&](const KartWork& w) { return w.level == level && failed(w); });
  const std::string title = failures ? fmt::format("{}, failed or unstable: {}", level, failures) : level;
  picture.command("set title " + quote(title) + " noenhanced offset 0,-0.6");
  picture.plot(curves);
}

}  // namespace

std::vector<KartWork> read_kart_work(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file, {"level", "ratio", "schedule", "to_fast", "to_slow",
                                           "max_pitch_difference", "seconds", "status"});
  std::vector<KartWork> work;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    work.push_back({row.text("level"), row.text("schedule"), row.text("to_fast"), row.text("to_slow"),
                    row.positive("ratio"),
                    row.text("status") == "ok" ? row.number("max_pitch_difference") : NAN,
                    row.number("seconds")});
  }
  return work;
}

Picture kart_work_chart(const std::vector<KartWork>& work, const std::vector<std::string>& caption) {
  if (work.empty()) throw Error(ErrorCode::input_output, "work.csv has no rows");
  const auto schemes = distinct(work, scheme_of);
  const auto levels = distinct(work, [](const KartWork& w) { return w.level; });
  const Sheet sheet(levels.size());
  Picture picture("kart_work", 1300, sheet.height());
  picture.title(
      "The kart with its engine at 0.1 ms: difference of the pitch against the time of 10 s of motion");
  picture.caption(caption);
  std::vector<Curve> names;
  for (std::size_t k = 0; k < schemes.size(); ++k) names.push_back({"", look(k, schemes[k]), schemes[k]});
  picture.legend(sheet.legend(), names, 3);
  picture.command(std::string(grid_command) + "; unset key; set logscale xy; set format xy '%g'");
  picture.command("set xtics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100)");
  picture.command(ranges(work));
  picture.command("set xlabel 'time of a run [s]'; set ylabel 'largest difference [deg]'");
  for (std::size_t k = 0; k < levels.size(); ++k) {
    picture.panel(sheet.panel(k));
    draw_level(picture, work, levels[k], schemes);
  }
  return picture;
}

}  // namespace tandem::charts
