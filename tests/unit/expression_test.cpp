// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What expressions of columns have beyond those of parameters (values_test.cpp): words, names with dots, many
// values.
#include "tandem/text/expression.hpp"

#include <gtest/gtest.h>

#include <array>

#include "refusal.hpp"

namespace tandem::text {
namespace {

const FileValues values = {
    {"how", "lagrange1"}, {"schedule", "slowest-first"}, {"step", 1e-3}, {"motor.w", 3.0}, {"x[2]", 5.0}};

TEST(Expressions, CompareWords) {
  for (const auto& [expression, value] : std::initializer_list<std::pair<const char*, double>>{
           {"(schedule is slowest-first)", 1.0},
           {"(schedule is parallel)", 0.0},
           {"(how in [lagrange0, lagrange1])", 1.0},
           {"( how in[lagrange0,lagrange10] )", 0.0},
           {"(how is lagrange1) && step < 2e-3", 1.0},
           {"(how is lagrange1) ? step/2 : step", 5e-4},
           {"2*(schedule is parallel) + 3*(how is lagrange1)", 3.0}})
    EXPECT_EQ(evaluated(expression, values), value) << expression;
}

TEST(Expressions, TakeNoNameFromColumnsForTheirConditions) {
  EXPECT_EQ(evaluated("_c0 + (how is slow)", {{"_c0", 5.0}, {"_c1", 7.0}, {"how", "slow"}}), 6.0);
  EXPECT_EQ(Expression("_c0*x + sin", {{"_c0", 2.0}, {"sin", 3.0}}).at(std::array{4.0}), 11.0);
}

TEST(Expressions, CompareOnlyWordsWithWords) {
  const auto refuses = [](const std::string& expression, const std::vector<std::string>& says) {
    EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, says, [&] { evaluated(expression, values); }))
        << expression;
  };
  refuses("(step is small)", {"step", "number 0.001", "=="});
  refuses("2*how", {"how", "'lagrange1'", "(how is WORD)"});
  refuses("(hw is lagrange1)", {"hw", "not there"});
  refuses("(how in lagrange1)", {"can't be read"});
  refuses("how is lagrange1", {"can't be read"});
}

TEST(Expressions, ThatEndInTheMiddleOfAConditionAreRefused) {
  const std::string whole = "2*(how in [lagrange0, lagrange1]) + (schedule is parallel)";
  EXPECT_EQ(evaluated(whole, values), 2.0);
  EXPECT_EQ(evaluated("((how is lagrange1))", values), 1.0);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string cut = whole.substr(0, length);
    if (cut == "2" || length == whole.find(" +") || length == whole.find("+"))
      continue;  // these are expressions
    EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {}, [&] { evaluated(cut, values); })) << cut;
  }
}

TEST(Expressions, HaveNamesWithDotsAndIndices) {
  EXPECT_EQ(evaluated("2*motor.w + x[2]", values), 11.0);
  EXPECT_EQ(evaluated("2.5*motor.w", values), 7.5);
  Expression twice("motor.w + x[2]*motor.w");
  EXPECT_EQ(twice.numbers(), (std::vector<std::string>{"motor.w", "x[2]"}));
}

TEST(Expressions, AreCompiledOnceForManyValues) {
  Expression energy("0.5*m*v^2 + m*9.81*h");
  for (int k = 0; k < 1000; ++k) {
    const double m = 1.0 + k, v = 0.1 * k, h = 3.0 - k;
    EXPECT_EQ(energy.at(std::array{m, v, h}), 0.5 * m * (v * v) + m * 9.81 * h) << k;
  }
}

TEST(Expressions, HaveConstantsThatAreNotAskedFor) {
  Expression scaled("(2*a)^2*x + b", {{"a", 3.0}, {"b", "word"}});
  EXPECT_EQ(scaled.numbers(), (std::vector<std::string>{"x", "b"}));
  EXPECT_EQ(scaled.at(std::array{2.0, 0.5}), 72.5);
}

TEST(Expressions, StandForValuesAfterADollar) {
  EXPECT_EQ(referred("$how", values), FileValue("lagrange1"));
  EXPECT_EQ(referred("$(step*4)", values), FileValue(4e-3));
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"'hw'", "did you mean 'how'"},
                            [] { referred("$hw", values); }));
  EXPECT_TRUE(
      test::refuses(ErrorCode::invalid_argument, {"$(step", "brackets"}, [] { referred("$(step", values); }));
}

}  // namespace
}  // namespace tandem::text
