// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The propagators that the orders are measured with are exact themselves.
#include "exact_masses.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "exact_relaxation.hpp"

namespace tandem::test {
namespace {

// x = 2 + t - 3 t^2 + t^3 solves x'' + w^2 x = f u for a cubic u; origin of u and step away from 0. To some
// eps of the largest term.
TEST(Oscillator, FollowsAPolynomialUnderThePolynomialThatDrivesIt) {
  const double square = 39.5, f = 7.0, origin = 0.3;
  const auto x = [](double t) { return 2.0 + t - 3.0 * t * t + t * t * t; };
  const auto v = [](double t) { return 1.0 - 6.0 * t + 3.0 * t * t; };
  const auto c = shifted({0.0, 0.0, {2.0, 1.0, -3.0, 1.0}}, origin);  // x in powers of t - origin
  Segment u{1.0, origin, {}};
  for (std::size_t k = 0; k < 4; ++k)
    u.c[k] = (square * c[k] + (k < 2 ? static_cast<double>((k + 1) * (k + 2)) * c[k + 2] : 0.0)) / f;
  double place = x(-0.1), speed = v(-0.1);
  Oscillator{square, f}.propagate(u, -0.1, 0.35, place, speed);
  EXPECT_NEAR(place, x(0.35), 1e-14 * 10);
  EXPECT_NEAR(speed, v(0.35), 1e-14 * 100);
}

TEST(Oscillator, SwingsFreelyAsSineAndCosine) {
  const double w = 2.0 * 3.141592653589793;
  double place = 0.6, speed = -1.1;
  Oscillator{w * w, 1.0}.propagate({1.0, 0.0, {}}, 0.0, 0.2, place, speed);
  EXPECT_NEAR(place, 0.6 * std::cos(0.2 * w) - 1.1 / w * std::sin(0.2 * w), 1e-15 * 10);
  EXPECT_NEAR(speed, -0.6 * w * std::sin(0.2 * w) - 1.1 * std::cos(0.2 * w), 1e-15 * 100);
}

// Breaks inside the step, and one within rounding of its beginning, as a coordinator gives them.
TEST(Pieces, CoverTheStepOnceAndInOrder) {
  const std::array segments{Segment{1.0, 1.0, {}}, Segment{1.25, 1.25, {}}, Segment{1.5, 1.5, {}},
                            Segment{1.75, 1.75, {}}};
  const Signal u(segments.data(), 4, 0);
  std::array<double, 4> ends{};
  std::size_t count = 0;
  double at = 1.0;
  for_each_piece(u, {1.0, 1.6, 0.6}, [&](const Segment& piece, double from, double to) {
    EXPECT_EQ(from, at);
    EXPECT_LE(to, piece.end);
    at = ends.at(count++) = to;
  });
  EXPECT_EQ(count, 3U);
  EXPECT_EQ(at, 1.6);
}

// Together the two sides of Relaxation move as it says: x' at the start by differences of a short step, h =
// 1e-4, whose error is h^2 (2w)^3 / 6.
TEST(Relaxation, SolvesItsOwnEquations) {
  const Relaxation r{.k = 0.5};
  const double t = 0.7, h = 1e-4;
  const auto [a, b] = r.exact(t);
  const auto before = r.exact(t - h), after = r.exact(t + h);
  EXPECT_NEAR((after[0] - before[0]) / (2.0 * h), -(r.damping + r.k) * a + (b + r.k * a), 1e-6);
  EXPECT_NEAR((after[1] - before[1]) / (2.0 * h), -r.damping * b - r.w * r.w * a, 1e-6);
}

}  // namespace
}  // namespace tandem::test
