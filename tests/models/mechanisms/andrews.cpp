// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/andrews.hpp"

#include <cmath>
#include <numbers>

#include "mechanisms/one_degree.hpp"

namespace tandem::mechanisms {
namespace {

constexpr AndrewsParameters data;

Vector2 to_the_left(const Vector2& a) { return {-a[1], a[0]}; }

PlanePath to_the_left(const PlanePath& a) {
  return {to_the_left(a.value), to_the_left(a.first), to_the_left(a.second)};
}

/// The point at those distances from a and b; side is 1 to the left of the way from a to b, -1 to the right.
PlanePath meeting(const PlanePath& a, Real from_a, const PlanePath& b, Real from_b, Real side) {
  const PlanePath way = b - a;
  const Number inverse_square = inverse(dot(way, way)), half = fixed(Real{0.5L});
  const Number along = half + (from_a * from_a - from_b * from_b) / 2 * inverse_square;
  const Number across = sqrt(from_a * from_a * inverse_square - along * along);
  return a + along * way + side * across * to_the_left(way);
}

/// The moving joints and, of each body, the unit vector whose angle is counted.
struct AndrewsPaths {
  PlanePath F, E, G, H, D;
  std::array<PlanePath, 7> along;
};

AndrewsPaths andrews_paths(Real beta) {
  const PlanePath A = fixed(Vector2(data.xa, data.ya)), B = fixed(Vector2(data.xb, data.yb));
  const Number c = cos(coordinate(beta)), s = sin(coordinate(beta));
  const PlanePath crank{{c.value, s.value}, {c.first, s.first}, {c.second, s.second}};
  const PlanePath F = data.rr * crank, E = meeting(F, data.d, B, data.ss, 1);
  const PlanePath G = meeting(A, data.zt, E, data.e, 1), H = meeting(A, data.u, E, data.zf, -1);
  const PlanePath arm = 1 / data.ss * (E - B), D = B + data.sc * arm + data.sd * to_the_left(arm);
  return {F,
          E,
          G,
          H,
          D,
          {crank, 1 / data.d * (F - E), arm, 1 / data.e * (E - G), 1 / data.zt * (G - A),
           1 / data.zf * (E - H), 1 / data.u * (H - A)}};
}

OneDegree andrews_coefficients(Real beta) {
  const AndrewsPaths at = andrews_paths(beta);
  OneDegree sum;
  const auto add = [&](int body, const PlanePath& centre) {
    sum.add_product(centre, centre, data.mass[body]);
    sum.add_product(at.along[body], at.along[body], data.inertia[body]);
  };
  const auto& along = at.along;
  add(0, data.ra * along[0]);
  add(1, at.F - data.da * along[1]);
  add(2, data.sa * along[2] + data.sb * to_the_left(along[2]));
  add(3, at.G + (data.e - data.ea) * along[3]);
  add(4, data.ta * along[4] + data.tb * to_the_left(along[4]));
  add(5, at.H + (data.zf - data.fa) * along[5]);
  add(6, data.ua * along[6] - data.ub * to_the_left(along[6]));
  const Vector2 spring = at.D.value - Vector2(data.xc, data.yc);
  const Real pull = data.stiffness * (1 - data.free_length / spring.norm());
  sum.force = data.torque - pull * spring.dot(at.D.first);
  return sum;
}

/// An angle and its derivatives by time of the unit vector that it turns.
std::array<Real, 3> turned(const PlanePath& along, Real rate, Real acceleration) {
  const Vector2 left = to_the_left(along.value);
  const Real slope = left.dot(along.first), curvature = left.dot(along.second);
  return {std::atan2(along.value[1], along.value[0]), slope * rate,
          slope * acceleration + curvature * rate * rate};
}

AndrewsState::Joints joints(const AndrewsPaths& at, Vector2 PlanePath::*part, Real factor) {
  const auto of = [&](const PlanePath& path) -> Eigen::Vector2d {
    return (factor * path.*part).cast<double>();
  };
  return {of(at.F), of(at.E), of(at.G), of(at.H), of(at.D)};
}

}  // namespace

AndrewsState andrews(double t) {
  const auto [beta, rate] =
      advance_one_degree({-0.0617138900142764496358948458001L, 0}, t, andrews_coefficients);
  const AndrewsPaths at = andrews_paths(beta);
  const Real acceleration = andrews_coefficients(beta).acceleration(rate);
  AndrewsState state{{}, {}, {}, joints(at, &PlanePath::value, 1), joints(at, &PlanePath::first, rate)};
  std::array<std::array<Real, 3>, 7> turn;
  for (int body = 0; body < 7; ++body) turn[body] = turned(at.along[body], rate, acceleration);
  turn[0][0] = beta;
  constexpr Real quarter = std::numbers::pi_v<Real> / 2;
  for (const int from_below : {2, 3, 6}) turn[from_below][0] += quarter;
  for (int k = 0; k < 3; ++k) {
    turn[1][k] -= turn[0][k];
    turn[3][k] -= turn[4][k];
    turn[5][k] -= turn[6][k];
  }
  for (int i = 0; i < 7; ++i) {
    state.angles[i] = static_cast<double>(turn[i][0]);
    state.rates[i] = static_cast<double>(turn[i][1]);
    state.accelerations[i] = static_cast<double>(turn[i][2]);
  }
  return state;
}

}  // namespace tandem::mechanisms
