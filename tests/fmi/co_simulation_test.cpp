// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "fmus.hpp"
#include "refusal.hpp"

namespace tandem::test {
namespace {

/// Euler's method in steps of 0.1 s, as the FMU takes them: 0.9^n, and x' = -x beside it.
TEST(FmuCoSimulation, DecayTakesItsOwnStepsOfEuler) {
  const auto fmu = open_fmu("decay");
  const FmuRun run(*fmu, 10.0);
  ASSERT_EQ(run.rows.size(), 101U);
  for (std::size_t n = 0; n < run.rows.size(); ++n) {
    EXPECT_NEAR(run.rows[n][2], std::pow(0.9, n), 1e-14);
    EXPECT_EQ(run.rows[n][3], -run.rows[n][2]);
  }
}

TEST(FmuCoSimulation, ParametersAreSetByName) {
  const auto fmu = open_fmu("decay?set.k=2");
  EXPECT_NEAR(FmuRun(*fmu, 1.0).rows.back()[2], std::pow(0.8, 10), 1e-14);
}

/// With steps of 0.05 s it stands still in every second one, and says that all is well.
TEST(FmuCoSimulation, AStepThatItDoesNotTakeAndSaysItDoesEndsTheRun) {
  const auto fmu = open_fmu("decay?step=0.05");
  EXPECT_TRUE(
      refuses(ErrorCode::numerical, {"from 0 to 0.05 s", "its own time is 0 s"}, [&] { FmuRun(*fmu, 1.0); }));
}

TEST(FmuCoSimulation, MayBeginAgain) {
  const auto fmu = open_fmu("decay");
  const auto first = FmuRun(*fmu, 2.0).rows, second = FmuRun(*fmu, 2.0).rows;
  EXPECT_EQ(first, second);
}

/// A constant force on x'' = -2 x: outputs that follow the input at once are those of the step's end.
TEST(FmuCoSimulation, OutputsThatFollowAnInputAtOnceAreThoseOfTheStepsEnd) {
  for (const std::string held : {"mean", "left", "right", "middle"}) {
    const auto fmu = open_fmu("mass?type=cs&step=0.1&inputs=" + held);
    double row[8];
    Samples y(row, fmu->info().row_size(), 1);
    ASSERT_LE(fmu->info().row_size(), 8);
    const double u0 = 0.0;
    fmu->initialize(0.0, 1.0, {&u0, 1}, y);
    const Segment ramp{1.0, 0.0, {0.0, 1.0}};  // u = t
    const Signal u(&ramp, 1, 1);
    Samples next(row, fmu->info().row_size(), 1);
    fmu->advance(0.1, false, {&u, 1}, next);
    EXPECT_EQ(next.values(0)[2], 0.1 - next.values(0)[0]) << held;
  }
}

TEST(FmuCoSimulation, EveryTypeGoesThrough) {
  std::vector<std::string> told;
  const auto fmu = open(fmu_uri("types?type=cs&step=0.5&set.text=four"),
                        fmu_sources([&](const std::string& what) { told.push_back(what); }));
  const auto rows = FmuRun(*fmu, 1.0, {0.25, 1.5, -3.0, 1.0, 2.0}).rows;
  const std::vector<double> expected = {1.0, 0.0, 0.25, 1.5, -3.0, 1.0, 2.0, 2.0, 4.0};
  EXPECT_EQ(rows.back(), expected);
  EXPECT_TRUE(told.empty());
}

TEST(FmuCoSimulation, AValueThatIsNotWholeIsRoundedAndToldOnce) {
  std::vector<std::string> told;
  const auto fmu = open(fmu_uri("types?type=cs&step=0.5"),
                        fmu_sources([&](const std::string& what) { told.push_back(what); }));
  const auto rows = FmuRun(*fmu, 1.0, {0.0, 0.0, 2.75, 0.0, 1.0}).rows;
  EXPECT_EQ(rows.back()[4], 3.0);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("'whole_in' is 2.75 at t = 0 s, and is rounded to 3"), std::string::npos) << told[0];
}

TEST(FmuCoSimulation, AValueOutOfRangeEndsTheRun) {
  for (const auto& [inputs, text] : std::vector<std::pair<std::vector<double>, std::string>>{
           {{0.0, 0.0, 6.0, 0.0, 1.0}, "'whole_in' is 6 at t = 0 s; allowed are whole numbers from -5 to 5"},
           {{0.0, 0.0, 0.0, 2.0, 1.0}, "'flag_in' is 2"},
           {{0.0, 0.0, 0.0, 0.0, 0.0},
            "'choice_in' is 0 at t = 0 s; allowed are whole numbers from 1 to 2"}}) {
    const auto fmu = open_fmu("types?type=cs&step=0.5");
    EXPECT_TRUE(refuses(ErrorCode::numerical, {text}, [&] { FmuRun(*fmu, 1.0, inputs); }));
  }
}

}  // namespace
}  // namespace tandem::test
