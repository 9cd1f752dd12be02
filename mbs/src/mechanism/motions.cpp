// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/motions.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "refuse.hpp"

namespace tandem::mbs {
namespace {

/// Points over time; `bends` are second derivatives at them (all zero: straight pieces).
struct Points {
  std::string name;
  std::vector<double> times, values, bends;

  /// The piece that begins at or before t; a time may miss the ends by rounding.
  std::size_t piece(double t) const {
    const double slack = 8.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(t), 1e-300);
    if (!(t >= times.front() - slack && t <= times.back() + slack))
      throw Error(ErrorCode::numerical,
                  fmt::format("{} is asked for at t = {} s; it has data from {} to {} s, and nothing is "
                              "extrapolated",
                              name, t, times.front(), times.back()));
    const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, t);
    return static_cast<std::size_t>(after - times.begin()) - 1;
  }

  /// Cubic with the values and second derivatives of both ends (C. de Boor, A Practical Guide to Splines,
  /// 1978, ch. IV).
  InputValue at(double t) const {
    const std::size_t k = piece(t);
    const double h = times[k + 1] - times[k], a = (times[k + 1] - t) / h, b = (t - times[k]) / h;
    const double slope = (values[k + 1] - values[k]) / h;
    return {a * values[k] + b * values[k + 1] +
                h * h / 6.0 * ((a * a * a - a) * bends[k] + (b * b * b - b) * bends[k + 1]),
            slope + h / 6.0 * ((1.0 - 3.0 * a * a) * bends[k] + (3.0 * b * b - 1.0) * bends[k + 1]),
            a * bends[k] + b * bends[k + 1]};
  }

  /// Continuous slopes at the points within, no bend at the ends: a tridiagonal system, by elimination.
  void bend() {
    const std::size_t last = times.size() - 1;
    std::vector<double> pivot(times.size()), right(times.size());
    for (std::size_t k = 1; k < last; ++k) {
      const double before = times[k] - times[k - 1], after = times[k + 1] - times[k];
      pivot[k] = 2.0 * (before + after);
      right[k] = 6.0 * ((values[k + 1] - values[k]) / after - (values[k] - values[k - 1]) / before);
      if (k == 1) continue;
      pivot[k] -= before * before / pivot[k - 1];
      right[k] -= before / pivot[k - 1] * right[k - 1];
    }
    for (std::size_t k = last - 1; k > 0; --k)
      bends[k] = (right[k] - (times[k + 1] - times[k]) * bends[k + 1]) / pivot[k];
  }
};

}  // namespace

std::function<InputValue(double)> polynomial(std::vector<double> c) {
  return [c = std::move(c)](double t) {
    InputValue m;
    for (std::size_t k = c.size(); k-- > 0;) {
      m.acceleration = m.acceleration * t + 2.0 * m.rate;
      m.rate = m.rate * t + m.value;
      m.value = m.value * t + c[k];
    }
    return m;
  };
}

std::function<InputValue(double)> sine(const Sine& s) {
  const double w = 2.0 * std::numbers::pi * s.frequency;
  return [s, w](double t) {
    const double sine = s.amplitude * std::sin(w * t + s.phase),
                 cosine = s.amplitude * std::cos(w * t + s.phase);
    return InputValue{s.mean + sine, w * cosine, -w * w * sine};
  };
}

std::function<InputValue(double)> interpolated(std::vector<double> times, std::vector<double> values,
                                               Interpolation how, const std::string& name) {
  if (times.size() < 2)
    refuse("", fmt::format("{} has {} points; allowed are 2 or more", name, times.size()));
  if (times[0] == times[1] || times.end()[-1] == times.end()[-2])
    refuse("", name + " begins or ends with a time that is there twice");
  const auto twice = std::adjacent_find(times.begin(), times.end());
  if (how == Interpolation::spline && twice != times.end())
    refuse("",
           fmt::format("{} has the time {} s twice; allowed for a spline are times that rise", name, *twice));
  for (std::size_t k = 2; k < times.size(); ++k)
    if (times[k] == times[k - 2])
      refuse("", fmt::format("{} has the time {} s three times; allowed is once, or twice for a jump", name,
                             times[k]));
  auto points = std::make_shared<Points>(Points{name, std::move(times), std::move(values), {}});
  points->bends.assign(points->times.size(), 0.0);
  if (how == Interpolation::spline) points->bend();
  return [points = std::shared_ptr<const Points>(std::move(points))](double t) { return points->at(t); };
}

}  // namespace tandem::mbs
