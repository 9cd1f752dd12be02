// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/bricard.hpp"

#include <cmath>
#include <numbers>

#include "mechanisms/one_degree.hpp"

namespace tandem::mechanisms {
namespace {

using Points = std::array<SpacePath, 6>;

struct Shape {
  Number a, b, h;     ///< radii of the triangles of P0 and of P1, height of the first above the second [m]
  SpacePath p0_axis;  ///< of the joint at P0, with P0 at azimuth zero and z along the normal
};

/// The axis at P0 is across the rods there, (h, 0, b/2 - a) but for a factor that vanishes where they are in
/// line, s = pi. With sigma = a + b, 8/3 sin^2 s = (sigma + sqrt3 cos s)(sigma - sqrt3 cos s) takes that out.
Shape shape(Real s) {
  constexpr Real root3 = std::numbers::sqrt3_v<Real>;
  const Number angle = coordinate(s), half_sine = sin(0.5L * angle), half_cosine = cos(0.5L * angle);
  const Number h = 1 / root3 * sin(angle), difference = 1 / root3 * cos(angle);
  const Number sum = sqrt(fixed(Real{3}) - h * h);
  const Number factor = inverse(sum + fixed(root3)) * half_cosine * half_cosine;
  const SpacePath across = vector(half_sine * (fixed(Real{2}) - 4 / (3 * root3) * factor), fixed(Real{0}),
                                  -4.0L / 3 * half_cosine);
  return {0.5L * (sum + difference), 0.5L * (sum - difference), h,
          inverse(sqrt(dot(across, across))) * across};
}

/// The points on the ground's axes: y is the joint's axis at P0, z is from P0 to P5.
Points points(Real s) {
  const Shape at = shape(s);
  Points from_p0;
  for (int i = 0; i < 6; ++i) {
    const Real azimuth = i * std::numbers::pi_v<Real> / 3;
    const Number& radius = i % 2 == 0 ? at.a : at.b;
    from_p0[i] =
        vector(std::cos(azimuth) * radius - at.a, std::sin(azimuth) * radius, (i % 2 == 0 ? 0 : -1) * at.h);
  }
  const SpacePath y = at.p0_axis, z = from_p0[5], x = cross(y, z);
  for (SpacePath& p : from_p0) p = vector(dot(x, p), dot(y, p), dot(z, p));
  return from_p0;
}

OneDegree bricard_coefficients(Real s) {
  const Points p = points(s);
  OneDegree sum;
  for (int i = 0; i < 5; ++i) sum.add_rod(p[i], p[i + 1], 1);
  return sum;
}

}  // namespace

BricardState bricard(double t) {
  const auto [s, rate] = advance_one_degree({std::numbers::pi_v<Real> / 2, 0}, t, bricard_coefficients);
  const Points p = points(s);
  BricardState state;
  state.axes[0] = {0, 1, 0};
  for (int i = 0; i < 6; ++i) {
    state.points[i] = p[i].value.cast<double>();
    state.velocities[i] = (rate * p[i].first).cast<double>();
    const double twist = i % 2 == 0 ? 1 : -1;  // of rod i by a right angle
    if (i < 5) state.axes[i + 1] = twist * (p[i + 1].value - p[i].value).cast<double>().cross(state.axes[i]);
  }
  return state;
}

}  // namespace tandem::mechanisms
