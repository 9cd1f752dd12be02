// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/motions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "refusal.hpp"

namespace tandem::mbs {
namespace {

using test::refuses;

TEST(Motions, PolynomialAndSineHaveTheirDerivatives) {
  const InputValue p = polynomial({1, -2, 3, 0.5})(2.0);
  EXPECT_EQ(p.value, 1 - 4 + 12 + 4);
  EXPECT_EQ(p.rate, -2 + 12 + 6);
  EXPECT_EQ(p.acceleration, 6 + 6);
  const InputValue s = sine({2.0, 0.5, 0.3, 1.0})(0.7);
  const double w = std::acos(-1.0), phase = 0.7 * w + 0.3;
  EXPECT_DOUBLE_EQ(s.value, 1.0 + 2.0 * std::sin(phase));
  EXPECT_DOUBLE_EQ(s.rate, 2.0 * w * std::cos(phase));
  EXPECT_DOUBLE_EQ(s.acceleration, -2.0 * w * w * std::sin(phase));
}

/// A natural spline has y'' = 0 at its ends, as sin(x) has on [0, pi]: then its error is of order 4
/// everywhere.
TEST(Motions, SplineIsOfOrderFourAndItsRatesOfThreeAndTwo) {
  const auto errors = [](int pieces) {
    std::vector<double> t, y;
    for (int k = 0; k <= pieces; ++k) {
      t.push_back(std::acos(-1.0) * k / pieces);
      y.push_back(std::sin(t.back()));
    }
    const auto f = data({"data", t, y, {TimeSeries::Between::spline}});
    std::array<double, 3> worst{};
    for (double x = 0.0; x < 3.14; x += 0.001) {
      const InputValue m = f(x);
      worst[0] = std::max(worst[0], std::abs(m.value - std::sin(x)));
      worst[1] = std::max(worst[1], std::abs(m.rate - std::cos(x)));
      worst[2] = std::max(worst[2], std::abs(m.acceleration + std::sin(x)));
    }
    return worst;
  };
  const auto coarse = errors(10), fine = errors(20);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(std::log2(coarse[k] / fine[k]), 4.0 - static_cast<double>(k), 0.2) << k;
}

TEST(Motions, RefuseWhatLiesBeyondTheData) {
  const auto f = data({"column 'F'", std::vector{1.0, 2.0}, std::vector{3.0, 4.0}, {}});
  EXPECT_EQ(f(2.0 + 4e-16).value, 4.0);  // rounding
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"column 'F'", "t = 2.1 s", "from 1 to 2 s"}, [&] { f(2.1); }));
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"t = 0.9 s"}, [&] { f(0.9); }));
}

}  // namespace
}  // namespace tandem::mbs
