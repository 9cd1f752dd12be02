// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A source that ended an own step early, where its reader stands: what is interpolated from there on begins
// where the reader is. Else a relay there switches to and fro without end.
#include <gtest/gtest.h>

#include <cmath>

#include "link_bench.hpp"

namespace tandem {
namespace {

double wave(double t) { return std::sin(5.0 * t); }
double slope(double t) { return 5.0 * std::cos(5.0 * t); }

/// Own nodes h apart up to 0.4 s, and a step that was cut at 0.4 s - cut.
struct CutStep : test::LinkBench {
  CutStep(const std::string& how, double h, double cut) : LinkBench(how, 0.0, {0, 0}, {1, 1}, h / 2.0) {
    for (int k = 6; k > 0; --k) give_wave(0.4 - k * h);
    if (cut > 0.0) give_wave(0.4 - cut);
    give_wave(0.4);
  }
  void give_wave(double t) { give(t, wave(t), 0.0, slope(t)); }
};

const std::vector<std::string> hows = {"lagrange0", "lagrange1", "lagrange2",
                                       "lagrange3", "lagrange4", "hermite"};

TEST(LinkJoined, WhatIsInterpolatedBeginsWhereTheStepWasCut) {
  for (const std::string& how : hows) {
    CutStep bench(how, 0.05, 0.02);
    const Signal u = bench.read(0.38, 0.4);
    EXPECT_NEAR(u.value(std::nextafter(0.38 + 1e-12, 1.0)), wave(0.38), 1e-10) << how;
    EXPECT_DOUBLE_EQ(u.value(0.4), wave(0.4)) << how;
  }
}

/// Of a step that was cut by rounding alone the quotient of the differences is anything, but not in between.
TEST(LinkJoined, NoDifferenceIsTooSmall) {
  for (const double cut : {1e-15, 1e-13, 1e-9}) {
    CutStep bench("lagrange4", 0.05, cut);
    const Signal u = bench.read(0.4 - cut, 0.4);
    EXPECT_NEAR(u.value(0.4 - cut / 2.0), wave(0.4), 1e-8) << cut;
    constexpr double bound = 3125.0 / 120.0 * 0.01 * 0.06 * 0.11 * 0.16 * 0.21;  // of the fifth derivative
    EXPECT_NEAR(u.value(0.41), wave(0.41), bound) << "extrapolated from own nodes";
  }
}

TEST(LinkJoined, WhatIsExtrapolatedGoesThroughOwnNodesAlone) {
  for (const std::string& how : hows) {
    CutStep cut(how, 0.05, 0.02), whole(how, 0.05, 0.0);
    for (const double from : {0.39, 0.4, 0.41})
      EXPECT_EQ(cut.read(from, 0.45).value(0.43), whole.read(from, 0.45).value(0.43)) << how << " " << from;
  }
}

TEST(LinkJoined, RowsThatAreTakenBackLeaveWhatWasThereBefore) {
  CutStep bench("lagrange3", 0.05, 0.02);
  const double beyond = bench.read(0.38, 0.45).value(0.43), between = bench.read(0.38, 0.45).value(0.39);
  bench.give_wave(0.45);
  EXPECT_NE(bench.read(0.38, 0.45).value(0.43), beyond);
  bench.history().withdraw(1);
  bench.link().withdraw(1);
  EXPECT_EQ(bench.read(0.38, 0.45).value(0.43), beyond);
  EXPECT_EQ(bench.read(0.38, 0.45).value(0.39), between);
}

/// Degree + 1, of a cubic by value and slope 4; of degree 0 that of a line.
TEST(LinkJoined, TheOrderIsThatOfTheDegree) {
  const double orders[] = {2.0, 2.0, 3.0, 4.0, 5.0, 4.0};
  for (std::size_t k = 0; k < hows.size(); ++k) {
    const auto error = [&](double h) {
      CutStep bench(hows[k], h, 0.4 * h);
      return std::abs(bench.read(0.4 - 0.4 * h, 0.4).value(0.4 - 0.2 * h) - wave(0.4 - 0.2 * h));
    };
    EXPECT_NEAR(std::log2(error(0.02) / error(0.01)), orders[k], 0.3) << hows[k];
  }
}

}  // namespace
}  // namespace tandem
