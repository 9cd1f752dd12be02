// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "fmus.hpp"

namespace tandem::test {
namespace {

/// RK4 of x' = -x: each step multiplies by the first five terms of exp(-h).
TEST(FmuModelExchange, DecayIsThatOfTheClassicalMethod) {
  const auto fmu = open_fmu("decay?type=me");
  const auto rows = FmuRun(*fmu, 10.0).rows;
  const double h = 0.1, factor = 1.0 - h + h * h / 2.0 - h * h * h / 6.0 + h * h * h * h / 24.0;
  ASSERT_EQ(rows.size(), 101U);
  for (std::size_t n = 0; n < rows.size(); ++n) EXPECT_NEAR(rows[n][2], std::pow(factor, n), 1e-14);
}

/// It falls from 1 m: the first bounce at sqrt(2/g), each flight e times as long as the one before.
TEST(FmuModelExchange, EachBounceOfTheBallIsWhereItIsInClosedForm) {
  const auto fmu = open_fmu("ball");
  std::vector<double> bounces;
  for (const auto& row : FmuRun(*fmu, 2.3).rows)
    if (row[1] == 1.0) bounces.push_back(row[0]);
  double t = std::sqrt(2.0 / 9.81), flight = 2.0 * t;
  ASSERT_GE(bounces.size(), 6U);
  for (const double bounce : bounces) {
    EXPECT_NEAR(bounce, t, 1e-9);
    t += flight *= 0.7;
  }
}

/// Two rows at each: the speed before and after.
TEST(FmuModelExchange, ABounceIsTwoRowsAtOneTime) {
  const auto fmu = open_fmu("ball");
  const auto rows = FmuRun(*fmu, 1.0).rows;
  std::size_t k = 0;
  while (rows[k][1] == 0.0) ++k;
  EXPECT_EQ(rows[k - 1][0], rows[k][0]);
  EXPECT_NEAR(rows[k - 1][3], -std::sqrt(2.0 * 9.81), 1e-9);
  EXPECT_NEAR(rows[k][3], -0.7 * rows[k - 1][3], 1e-12);
}

TEST(FmuModelExchange, TheStairRisesAtItsTimesAndEndsTheRun) {
  const auto fmu = open_fmu("stair?step=0.3");
  const FmuRun run(*fmu, 10.0);
  EXPECT_EQ(run.clock.stop, Stop::finished);
  EXPECT_EQ(run.clock.time, 4.0);
  for (const auto& row : run.rows) {
    const double before = std::ceil(row[0]) - (row[0] > 0.0 ? 1.0 : 0.0);
    EXPECT_EQ(row[2], row[1] == 1.0 ? row[0] : before) << row[0];
  }
}

/// Classical steps of 5 ms.
TEST(FmuModelExchange, VanDerPolIsRight) {
  const auto fmu = open_fmu("van_der_pol?type=me");
  EXPECT_NEAR(FmuRun(*fmu, 20.0).rows.back()[2], van_der_pol_at(20.0), 2e-8);
}

TEST(FmuModelExchange, EveryTypeGoesThrough) {
  const auto fmu = open_fmu("types?type=me&step=0.5&set.text=four");
  const auto rows = FmuRun(*fmu, 1.0, {0.25, 1.5, -3.0, 1.0, 2.0}).rows;
  const std::vector<double> expected = {1.0, 0.0, 0.25, 1.5, -3.0, 1.0, 2.0, 1.0, 4.0};
  EXPECT_EQ(rows.back(), expected);
}

/// Discrete inputs only in an event: one at their jump.
TEST(FmuModelExchange, ADiscreteInputThatJumpsMakesAnEvent) {
  const auto fmu = open_fmu("types?type=me&step=0.5");
  std::vector<double> memory(200);
  const auto stride = fmu->info().row_size();
  const std::vector<double> u0 = {0.0, 0.0, 0.0, 0.0, 1.0};
  Samples first(memory.data(), stride, 1);
  fmu->initialize(0.0, 2.0, u0, first);
  const JumpingInputs inputs(u0, 2, 0.75, 4.0, 2.0);
  Samples y(memory.data(), stride, 10);
  const Clock clock = fmu->advance(2.0, false, inputs.signals, y);
  EXPECT_EQ(clock.stop, Stop::event);
  ASSERT_EQ(y.size(), 3);
  EXPECT_EQ(y.time(1), 0.75);
  EXPECT_EQ(y.values(1)[2], 0.0);
  EXPECT_EQ(y.time(2), 0.75);
  EXPECT_TRUE(y.jump(2));
  EXPECT_EQ(y.values(2)[2], 4.0);
}

}  // namespace
}  // namespace tandem::test
