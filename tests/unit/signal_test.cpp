// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/signal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "polynomial.hpp"

namespace tandem {
namespace {

using test::Polynomial;

/// p about another origin.
Segment segment(const Polynomial& p, double end, double origin) {
  Segment s{end, origin, {}};
  Polynomial d = p;
  double factorial = 1.0;
  for (std::size_t k = 0; k < p.c.size(); ++k) {
    s.c[k] = d(origin) / factorial;
    d = d.derivative();
    factorial *= static_cast<double>(k + 1);
  }
  return s;
}

TEST(Signal, GivesThePolynomialAndItsDerivativesOfEveryDegree) {
  for (int degree = 0; degree < TANDEM_MAX_COEFFICIENTS; ++degree) {
    const Polynomial p = Polynomial::of_degree(degree);
    const Segment s = segment(p, 2.0, 1.5);
    const Signal signal(&s, 1, degree);
    for (double t = 0.0; t < 3.0; t += 0.1) {
      // 36 terms of at most 3.5 * 3^5 (20 times that in a second derivative), each with a few roundings of
      // 1.1e-16: below 1e-11, and 1e-10.
      EXPECT_NEAR(signal.value(t), p(t), 1e-11) << degree;
      EXPECT_NEAR(signal.derivative(t), p.derivative()(t), 1e-11) << degree;
      EXPECT_NEAR(signal.second_derivative(t), p.derivative().derivative()(t), 1e-10) << degree;
    }
    EXPECT_EQ(signal.degree(), degree);
  }
}

TEST(Signal, ABreakBelongsToTheSegmentBeforeIt) {
  const Segment s[] = {{1.0, 0.0, {10.0}}, {2.0, 0.0, {20.0}}, {3.0, 0.0, {30.0}}};
  const Signal signal(s, 3, 0);
  EXPECT_EQ(signal.value(1.0), 10.0);
  EXPECT_EQ(signal.value(std::nextafter(1.0, 2.0)), 20.0);
  EXPECT_EQ(signal.value(2.0), 20.0);
  EXPECT_EQ(signal.value(std::nextafter(2.0, 3.0)), 30.0);
}

TEST(Signal, TheFirstSegmentGoesOnBackwardsAndTheLastForwards) {
  const Segment s[] = {{1.0, 0.0, {0.0, 1.0}}, {2.0, 1.0, {5.0, -1.0}}};
  const Signal signal(s, 2, 1);
  EXPECT_EQ(signal.value(-3.0), -3.0);
  EXPECT_EQ(signal.value(7.0), 5.0 - 6.0);
  EXPECT_EQ(signal.derivative(-3.0), 1.0);
  EXPECT_EQ(signal.derivative(7.0), -1.0);
}

TEST(Signal, FindsItsSegmentAmongAnyNumber) {
  for (int count = 1; count <= 40; ++count) {
    std::vector<Segment> s;
    for (int k = 0; k < count; ++k) s.push_back({k + 1.0, 0.0, {static_cast<double>(k)}});
    const Signal signal(s.data(), count, 0);
    for (double t = -0.5; t < count + 1.0; t += 0.25)
      ASSERT_EQ(signal.value(t), std::clamp(std::ceil(t) - 1.0, 0.0, count - 1.0)) << t << " of " << count;
  }
}

TEST(Signal, SegmentsThatEndTogetherLeaveTheEndToTheFirst) {
  const Segment s[] = {{1.0, 0.0, {10.0}}, {1.0, 0.0, {20.0}}, {2.0, 0.0, {30.0}}};
  const Signal signal(s, 3, 0);
  EXPECT_EQ(signal.value(1.0), 10.0);
  EXPECT_EQ(signal.value(1.5), 30.0);
  EXPECT_EQ(signal.segments().size(), 3U);
}

}  // namespace
}  // namespace tandem
