// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "four_bar/course.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tandem::four_bar {
namespace {

Course exact_course(int loops, Start start, double interval, int count) {
  Course course;
  const auto path = exact_path(loops, start, interval, count);
  for (std::size_t k = 0; k < path.size(); ++k) {
    const double s = std::sin(path[k].angle), c = std::cos(path[k].angle);
    course.knots.push_back(
        {static_cast<double>(k) * interval, s, c, c * path[k].rate, -s * path[k].rate, 0.0});
  }
  return course;
}

TEST(LinkagePath, BeginsAsDescribedAndKeepsItsEnergy) {
  for (const Start start : {Start::upright, Start::hanging}) {
    const auto path = exact_path(3, start, 0.05, 400);
    EXPECT_EQ(path.size(), 401u);
    EXPECT_EQ(std::cos(path[0].angle) * path[0].rate, 1.0);  // m/s
    const double c = 1.5 * 9.81 * 10.0 / 13.0;
    const auto energy = [&](const Crank& k) { return 0.5 * k.rate * k.rate + c * std::cos(k.angle); };
    for (const Crank& k : path) EXPECT_NEAR(energy(k), energy(path[0]), 1e-9);
  }
}

TEST(LinkagePath, IsTheSameAsTheMotionAtATime) {
  EXPECT_NEAR(exact_path(2, Start::upright, 0.1, 20).back().angle, exact(2, 2.0).angle, 1e-10);
}

TEST(LinkagePath, HangingStaysBelow18Degrees) {
  for (const int loops : {1, 1000})
    for (const Crank& k : exact_path(loops, Start::hanging, 0.01, 1000))
      EXPECT_LT(std::abs(k.angle - std::numbers::pi), 18.0 / 180.0 * std::numbers::pi);
}

/// Cubic Hermite polynomials err by h^4/384 |x''''| at most, and |x''''| is below (w^2)^2 times the amplitude
/// of 0.3 m with w^2 < 12, or w^2 a^2 rate terms of the same size: halved knots, a sixteenth.
TEST(LinkageCourse, OfExactKnotsErrsByItsInterpolationAlone) {
  const auto path = exact_path(2, Start::hanging, 0.001, 2000);
  const double coarse = rms_error(exact_course(2, Start::hanging, 0.1, 20), path, 0.001);
  const double fine = rms_error(exact_course(2, Start::hanging, 0.05, 40), path, 0.001);
  EXPECT_LT(coarse, std::pow(0.1, 4) / 384.0 * 4.0 * 12.0 * 12.0 * 0.3);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.1);
}

TEST(LinkageCourse, OfOnePlaceHasTheDistanceForItsError) {
  auto course = exact_course(1, Start::upright, 0.01, 50);
  for (Knot& k : course.knots) k.x += 3e-3, k.y += 4e-3;
  EXPECT_NEAR(rms_error(course, exact_path(1, Start::upright, 0.01, 50), 0.01), 5e-3, 1e-10);
}

TEST(LinkageCourse, SaysWhereItWasLostFailedOrGivenUp) {
  auto course = exact_course(1, Start::upright, 0.25, 4);
  EXPECT_EQ(status(course), "ok");
  course.ended = Course::Ended::given_up;
  EXPECT_EQ(status(course), "given up at 1 s");
  course.ended = Course::Ended::failed;
  EXPECT_EQ(status(course), "failed at 1 s");
  EXPECT_TRUE(std::isnan(rms_error(course, exact_path(1, Start::upright, 0.01, 50), 0.01)));
  course.ended = Course::Ended::lost;
  EXPECT_EQ(status(course), "lost at 1 s");
  EXPECT_FALSE(lost(course.knots.back()));
  course.knots.back().skew = 0.11;
  EXPECT_TRUE(lost(course.knots.back()));
  course.knots.back().skew = std::nan("");
  EXPECT_TRUE(lost(course.knots.back()));
}

}  // namespace
}  // namespace tandem::four_bar
