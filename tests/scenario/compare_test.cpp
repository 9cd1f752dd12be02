// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "command.hpp"
#include "refusal.hpp"
#include "tandem/scenario/comparison.hpp"

namespace tandem {
namespace {

using test::Said;
using test::Scratch;
using test::tandem;

class CompareCommand : public testing::Test {
 protected:
  CompareCommand() {
    folder.write("a.csv", "time,x,y\n0,1,0\n1,2,0\n2,4,1\n");
    folder.write("b.csv", "time,x,y\n0,1,0\n1,2.2,0\n2,4,1\n");
  }
  const Scratch folder;
};

TEST_F(CompareCommand, WithinTheToleranceIsStatusZero) {
  const Said said = tandem(folder, {"compare", "a.csv", "b.csv", "--tolerance", "0.051"});
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_NE(said.out.find("within the tolerance"), std::string::npos) << said.out;
  EXPECT_EQ(tandem(folder, {"compare", "a.csv", "a.csv"}).status, 0);
}

TEST_F(CompareCommand, BeyondItIsStatusOneWithPlaceAndFigures) {
  const Said said = tandem(folder, {"compare", "a.csv", "b.csv", "--tolerance", "0.04"});
  EXPECT_EQ(said.status, 1);
  EXPECT_NE(said.err.find("x differs by 0.2 (5 % of its largest magnitude) at t = 1 s: 2 and 2.2"),
            std::string::npos)
      << said.err;
}

TEST_F(CompareCommand, TakesOnlyTheColumnsThatAreNamed) {
  EXPECT_EQ(tandem(folder, {"compare", "a.csv", "b.csv", "--columns", "y"}).status, 0);
  EXPECT_EQ(tandem(folder, {"compare", "a.csv", "b.csv", "--columns", "y,x"}).status, 1);
}

TEST_F(CompareCommand, BadInputIsStatusTwo) {
  folder.write("late.csv", "time,x\n5,1\n");
  folder.write("broken.csv", "time,x\n0,1\n1,two\n");
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& words) {
    const Said said = tandem(folder, arguments);
    EXPECT_EQ(said.status, 2) << said.err;
    EXPECT_NE(said.err.find(words), std::string::npos) << said.err;
  };
  refused({"compare", "a.csv", "b.csv", "--columns", "z"}, "'z' is not there");
  refused({"compare", "a.csv", "late.csv"}, "no time is in both");
  refused({"compare", "a.csv", "broken.csv"}, "broken.csv:3: column 2 holds something else");
  refused({"compare", "a.csv", "nowhere.csv"}, "'nowhere.csv' is not there");
  refused({"compare", "a.csv", "b.csv", "--tolerance", "-1"}, "--tolerance");
  refused({"compare", "a.csv", "b.csv", "--from", "nan"}, "--from: 'nan' is given; allowed is a number");
  refused({"compare", "a.csv", "b.csv", "--to", "nan"}, "--to: 'nan' is given; allowed is a number");
  refused({"compare", "a.csv", "b.csv", "--from", "inf"}, "times from inf to inf s are to be compared");
  refused({"compare", "a.csv", "b.csv", "--from", "3"}, "from 3 to inf s count");
  for (const char* shift : {"0", "-1", "nan", "inf", "x"})
    refused({"compare", "a.csv", "b.csv", "--shift", shift}, "tandem: --shift: '");
}

/// The sum of three tenths is later than 0.3 by rounding.
TEST_F(CompareCommand, AWindowEndsWithRounding) {
  folder.write("c.csv", "time,x\n0,1\n0.30000000000000004,7\n");
  folder.write("d.csv", "time,x\n0,1\n0.30000000000000004,1\n");
  EXPECT_EQ(tandem(folder, {"compare", "c.csv", "d.csv", "--to", "0.3"}).status, 1);
}

/// Their ends alone are the same, ten seconds apart.
TEST(Comparison, AShiftLeavesHalfOfTheTimes) {
  text::TimeTable a{"a", {}, {"x"}, {{}}};
  for (int row = 0; row <= 100; ++row) a.times.push_back(0.1 * row), a.columns[0].push_back(row);
  text::TimeTable b = a;
  for (double& x : b.columns[0]) x += 100.0;
  const scenario::Comparison compared = scenario::compare(a, b, {}, {.shift = 20.0});
  EXPECT_GE(compared.times, 51U);
  EXPECT_NEAR(compared.shift, 5.0, 0.1);
}

/// A wave that dies out, of a cycle a second. It is late by an odd part of it, and agrees nowhere else as well.
TEST(Comparison, ALargerShiftThatIsAllowedMakesNothingWorse) {
  text::TimeTable a{"a", {}, {"x"}, {{}}}, b = a;
  for (int row = 0; row <= 4000; ++row) {
    const double t = 0.01 * row;
    const auto wave = [](double at) { return std::exp(-0.05 * at) * std::sin(2.0 * std::numbers::pi * at); };
    a.times.push_back(t), a.columns[0].push_back(wave(t - 0.0873));
    b.times.push_back(t), b.columns[0].push_back(wave(t));
  }
  for (const double most : {0.1, 0.5, 2.0, 5.0, 15.0}) {
    const scenario::Comparison compared = scenario::compare(a, b, {}, {.shift = most});
    EXPECT_NEAR(compared.shift, 0.0873, 2e-4) << most;
    EXPECT_LT(compared.columns[0].relative_rms, 2e-3) << most;
  }
}

/// Work is bounded whatever turns at each row. Beyond their length two tables have no time in common.
TEST(Comparison, TheShiftOfNoiseIsFoundInTime) {
  text::TimeTable a{"a", {}, {"x"}, {{}}}, b = a;
  for (int row = 0; row < 100000; ++row)
    b.times.push_back(1e-4 * row), b.columns[0].push_back(row % 2 + 1e-5 * row);
  for (int row = 0; row < 10; ++row) a.times.push_back(row), a.columns[0].push_back(0.1 * row);
  for (const double most : {1.0, 1e7})
    EXPECT_LE(std::abs(scenario::compare(a, b, {}, {.shift = most}).shift), 10.0);
}

TEST(Comparison, SquaresOfSmallAndLargeValuesAreNumbers) {
  for (const double size : {1e-200, 1e200}) {
    const text::TimeTable a{"a", {0.0, 1.0}, {"x"}, {{size, size}}},
        b{"b", {0.0, 1.0}, {"x"}, {{2 * size, 2 * size}}};
    const scenario::Difference x = scenario::compare(a, b).columns[0];
    EXPECT_DOUBLE_EQ(x.relative_rms, 0.5);
    EXPECT_DOUBLE_EQ(x.rms, size);
  }
}

TEST(Comparison, ATableWithoutRowsIsRefused) {
  const text::TimeTable none{"none", {}, {"x"}, {{}}};
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"none has no rows"},
                            [&] { scenario::compare(none, none); }));
}

}  // namespace
}  // namespace tandem
