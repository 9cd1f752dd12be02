// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "four_bar/course.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem::four_bar {
namespace {

/// The cubic through both values with both rates, at the part s of the length h.
double hermite(double s, double h, double from, double from_rate, double to, double to_rate) {
  const double r = 1.0 - s;
  return r * r * ((1.0 + 2.0 * s) * from + s * h * from_rate) +
         s * s * ((1.0 + 2.0 * r) * to - r * h * to_rate);
}

double distance(const Knot& a, const Knot& b, double time, const Crank& exact) {
  const double h = b.time - a.time, s = (time - a.time) / h;
  return std::hypot(hermite(s, h, a.x, a.vx, b.x, b.vx) - std::sin(exact.angle),
                    hermite(s, h, a.y, a.vy, b.y, b.vy) - std::cos(exact.angle));
}

}  // namespace

double rms_error(const Course& course, const std::vector<Crank>& exact, double interval) {
  if (course.ended != Course::Ended::at_the_end || course.knots.size() < 2)
    return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  auto to = course.knots.begin() + 1;
  for (std::size_t k = 0; k < exact.size(); ++k) {
    const double time = static_cast<double>(k) * interval;
    while (to + 1 != course.knots.end() && to->time < time) ++to;
    const double d = distance(*(to - 1), *to, time, exact[k]);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(exact.size()));
}

std::string status(const Course& course) {
  static constexpr const char* words[] = {"ok", "lost", "failed", "given up"};
  const char* word = words[static_cast<int>(course.ended)];
  if (course.ended == Course::Ended::at_the_end) return word;
  return fmt::format("{} at {:.3g} s", word, course.knots.empty() ? 0.0 : course.knots.back().time);
}

}  // namespace tandem::four_bar
