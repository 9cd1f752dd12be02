// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/spatial_slider_crank.hpp"

#include <cmath>

#include "mechanisms/one_degree.hpp"

namespace tandem::mechanisms {
namespace {

constexpr Real spatial_crank_mass = 0.12L, crank_inertia = 1e-4L, spatial_rod_mass = 0.5L, rod_length = 0.3L;
constexpr Real rod_across = 4e-3L, rod_along = 4e-4L, spatial_slider_mass = 2;

struct SpatialPaths {
  SpacePath pivot, crank_end, slider, direction;  ///< direction of the rod from the crank
};

SpatialPaths spatial_paths(Real angle) {
  const Number s = coordinate(angle), zero = fixed(Real{0});
  const SpacePath pivot = fixed(Vector3(0, 0.1L, 0.12L));
  const SpacePath crank_end = pivot + vector(zero, -0.08L * sin(s), 0.08L * cos(s));
  const Number x = sqrt(fixed(rod_length * rod_length) - dot(crank_end, crank_end));
  const SpacePath slider = vector(x, zero, zero);
  return {pivot, crank_end, slider, 1 / rod_length * (slider - crank_end)};
}

/// The rod's angular velocity along itself for an angular velocity of the crank of one, and its slope.
struct Spin {
  Real value, slope;
};

Spin spin(const SpacePath& d) {
  const Real turn = d.value.cross(d.first)[0], turn_slope = d.value.cross(d.second)[0];
  const Real x = d.value[0], rest = 1 - x * x;
  return {turn * x / rest, turn_slope * x / rest + turn * d.first[0] * (1 + x * x) / (rest * rest)};
}

OneDegree spatial_slider_coefficients(Real angle) {
  const SpatialPaths at = spatial_paths(angle);
  const SpacePath crank_centre = 0.5L * (at.pivot + at.crank_end),
                  rod_centre = 0.5L * (at.crank_end + at.slider);
  const Spin along = spin(at.direction);
  OneDegree sum{
      crank_inertia + rod_along * along.value * along.value, 2 * rod_along * along.value * along.slope,
      -gravity * (spatial_crank_mass * crank_centre.first[2] + spatial_rod_mass * rod_centre.first[2])};
  sum.add_product(crank_centre, crank_centre, spatial_crank_mass);
  sum.add_product(rod_centre, rod_centre, spatial_rod_mass);
  sum.add_product(at.direction, at.direction, rod_across);
  sum.add_product(at.slider, at.slider, spatial_slider_mass);
  return sum;
}

}  // namespace

SpatialSliderCrankState spatial_slider_crank(double t) {
  const auto [angle, rate] = advance_one_degree({0, 6}, t, spatial_slider_coefficients);
  const SpatialPaths at = spatial_paths(angle);
  const SpacePath& d = at.direction;
  const Vector3 cross = Vector3(0, -d.value[2], d.value[1]).normalized();
  const Vector3 turn = rate * (d.value.cross(d.first) + spin(d).value * d.value);
  return {static_cast<double>(angle),
          static_cast<double>(rate),
          at.crank_end.value.cast<double>(),
          (rate * at.crank_end.first).cast<double>(),
          at.slider.value.cast<double>(),
          (rate * at.slider.first).cast<double>(),
          cross.cast<double>(),
          turn.cast<double>()};
}

}  // namespace tandem::mechanisms
