// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/error_axis.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tandem::charts {
namespace {

constexpr double limit = 100.0 * failure_limit;
constexpr double row_height = 0.05;  // of the height below the strip

/// To 1, 2 or 5 times a power of ten.
double round_down(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  return value >= 5.0 * decade ? 5.0 * decade : value >= 2.0 * decade ? 2.0 * decade : decade;
}

std::string tic(double percent, bool numbered) {
  return fmt::format("'{}' {:g}", numbered ? fmt::format("{:g}", percent) : "", percent);
}

}  // namespace

ErrorAxis::ErrorAxis(double smallest, int rows)
    : bottom_(round_down(std::min(100.0 * smallest, 0.1 * limit))),
      top_(limit * std::pow(limit / bottom_, row_height * rows + 0.05)),
      rows_(rows) {}

double ErrorAxis::strip(int row) const { return limit * std::pow(top_ / limit, (row + 0.5) / rows_); }

void ErrorAxis::apply(Picture& picture, const std::string& label, const std::string& strip_text) const {
  picture.command(fmt::format("set logscale y; set yrange [{}:{}]; set ylabel {} noenhanced", bottom_, top_,
                              quote(label)));
  std::string tics;
  for (int power = static_cast<int>(std::ceil(std::log10(bottom_) - 1e-9)); power <= 1; ++power)
    tics += tic(std::pow(10.0, power), !label.empty()) + ", ";
  picture.command("set xtics nomirror; set ytics (" + tics + tic(limit, !label.empty()) + ")");
  picture.command(fmt::format(
      "set object 1 rectangle from graph 0, first {} to graph 1, graph 1 behind fc rgb '#E4E4E4' fs "
      "solid noborder",
      limit));
  picture.command(
      fmt::format("set label 99 {} at graph 0.015, first {} left noenhanced font small tc rgb '#404040'",
                  quote(strip_text), strip(rows_ - 1)));
}

void ErrorAxis::end(Picture& picture) {
  picture.command(
      "unset object 1; unset label 99; set xtics mirror; unset logscale; set ytics autofreq; unset ylabel; "
      "unset title");
}

}  // namespace tandem::charts
