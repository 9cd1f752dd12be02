// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "tandem/scenario/comparison.hpp"

namespace tandem::scenario {
namespace {

std::string percent(double fraction) { return fmt::format("{:.3g} %", 100.0 * fraction); }

std::string how_compared(const Comparison& c) {
  std::string line = fmt::format("compared at {} times of {}", c.times, c.at);
  if (c.interpolated > 0) {
    line += fmt::format("; at {} of them the other has no row and is interpolated", c.interpolated);
    if (c.linear.empty())
      line += " by Hermite polynomials";
    else if (c.linear.size() == c.columns.size())
      line += " linearly";
    else
      line += fmt::format(" by Hermite polynomials, {} linearly", fmt::join(c.linear, ", "));
  }
  if (c.shift != 0.0)
    line += fmt::format("\nas a whole {:.6g} s {}", std::abs(c.shift), c.shift > 0.0 ? "later" : "earlier");
  return line + "\n";
}

}  // namespace

std::string text(const Comparison& comparison) {
  std::string lines = fmt::format("{:<24} {:>14} {:>12} {:>12} {:>12} {:>12}\n", "column", "largest diff.",
                                  "relative", "at time [s]", "rms", "relative");
  for (const Difference& d : comparison.columns)
    lines += fmt::format("{:<24} {:>14.6g} {:>12} {:>12.6g} {:>12.6g} {:>12}\n", d.column, d.absolute,
                         percent(d.relative), d.time, d.rms, percent(d.relative_rms));
  lines += how_compared(comparison);
  for (const std::string& sentence : comparison.uncompared) lines += sentence + '\n';
  return lines;
}

std::string text(const Difference& d, double tolerance, Norm norm) {
  if (norm == Norm::rms)
    return fmt::format("{} differs by {:.6g} in rms ({} of its rms); tolerance {}", d.column, d.rms,
                       percent(d.relative_rms), percent(tolerance));
  return fmt::format(
      "{} differs by {:.6g} ({} of its largest magnitude) at t = {:.6g} s: {:.9g} and {:.9g}; tolerance {}",
      d.column, d.absolute, percent(d.relative), d.time, d.a, d.b, percent(tolerance));
}

std::string beyond(const Comparison& comparison, double tolerance, Norm norm) {
  const auto worst =
      std::max_element(comparison.columns.begin(), comparison.columns.end(),
                       [&](const Difference& x, const Difference& y) { return x.size(norm) < y.size(norm); });
  if (!(worst->size(norm) <= tolerance)) return text(*worst, tolerance, norm);
  return comparison.uncompared.empty() ? std::string() : "not the same: " + comparison.uncompared.front();
}

}  // namespace tandem::scenario
