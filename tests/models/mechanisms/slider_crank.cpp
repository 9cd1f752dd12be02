// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/slider_crank.hpp"

#include <cmath>
#include <numbers>

#include "mechanisms/one_degree.hpp"

namespace tandem::mechanisms {
namespace {

constexpr Real crank = 0.2L, rod = 0.6L, crank_mass = 0.5L, rod_mass = 1, slider_mass = 0.4L;

/// The slider's place and its first two derivatives by the crank's angle.
std::array<Real, 3> slider(Real angle) {
  const Real y = crank * std::sin(angle), x = crank * std::cos(angle), level = std::sqrt(rod * rod - y * y);
  const Real slope = -x * y / level;  // of level
  return {x + level, -y + slope, -x - (x * x - y * y + slope * slope) / level};
}

OneDegree slider_coefficients(Real angle) {
  const auto [place, d1, d2] = slider(angle);
  const Real y = crank * std::sin(angle), x = crank * std::cos(angle);
  return {crank_mass * crank * crank / 3 + rod_mass / 3 * (crank * crank - y * d1 + d1 * d1) +
              slider_mass * d1 * d1,
          rod_mass / 3 * (-x * d1 - y * d2 + 2 * d1 * d2) + 2 * slider_mass * d1 * d2,
          -gravity * (crank_mass + rod_mass) / 2 * x};
}

}  // namespace

SliderCrankState slider_crank(double t) {
  const auto [angle, rate] = advance_one_degree({std::numbers::pi_v<Real> / 4, 10}, t, slider_coefficients);
  const auto [place, slope, curvature] = slider(angle);
  const Vector2 crank_end(crank * std::cos(angle), crank * std::sin(angle));
  const Vector2 velocity(-rate * crank_end[1], rate * crank_end[0]);
  return {static_cast<double>(angle),        static_cast<double>(rate), static_cast<double>(place),
          static_cast<double>(rate * slope), crank_end.cast<double>(),  velocity.cast<double>()};
}

}  // namespace tandem::mechanisms
