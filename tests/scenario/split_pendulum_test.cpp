// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The double pendulum that is split at its elbow, as its studies judge it.
#include <gtest/gtest.h>

#include <cmath>

#include "command.hpp"
#include "tandem/charts/csv_table.hpp"

namespace tandem::split_pendulum_tests {
namespace {

using charts::CsvTable;
using test::Said;
using test::Scratch;
using test::tandem;

const std::string scene = TANDEM_SOURCE_DIR "/scenarios/split_pendulum/";

CsvTable swept(const Scratch& folder, const std::string& study, const std::string& table,
               const std::string& where) {
  const Said said =
      tandem(folder, {"sweep", scene + study, "--table", table, "--where", where, "--output", "o"});
  EXPECT_EQ(said.status, 0) << said.err;
  return CsvTable::read(folder.path() / "o" / (table + ".csv"), {});
}

CsvTable schemes(const Scratch& folder, const std::string& where) {
  return swept(folder, "study.toml", "schemes", "(formulation is null_space) && ratio == 10 && " + where);
}

TEST(SplitPendulum, TheWholeOneIsOfOrderTwo) {
  const Scratch folder;
  const auto table = swept(folder, "study.toml", "monolithic", "lower_mass == 0.1");
  ASSERT_EQ(table.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(table[k].number("order"), 2.0, 0.2);
}

/// The figures of the card, with a quarter of the lower rod's mass carried, which is what resists at the
/// start.
TEST(SplitPendulum, IsOfOrderTwoWithTheCarriedMass) {
  const Scratch folder;
  const auto table = schemes(
      folder,
      "carried_mass == 0.025 && lower_mass == 0.1 && (lag is none) && ((to_lower is lagrange4) && "
      "((schedule is slowest-first) && (to_upper is lagrange1) && (fast is lower) || (schedule is "
      "fastest-first) && ((to_upper is lagrange1) && (fast is upper) || (to_upper is lagrange4) && (fast "
      "is lower))) || (to_lower is least_squares3_2) && (fast is lower))");
  ASSERT_EQ(table.size(), 4U);
  for (std::size_t k = 0; k < table.size(); ++k) {
    EXPECT_LT(table[k].number("largest_error"), table[k].text("to_upper") == "mean" ? 2e-4 : 6e-5) << k;
    EXPECT_NEAR(table[k].number("order"), 2.0, 0.2) << k;
    EXPECT_LE(table[k].number("rms_error"), table[k].number("largest_error"));
  }
}

/// At the limit of stability: the run with half the steps fails, and the row says why it has no order.
TEST(SplitPendulum, TellsWhyThereIsNoOrder) {
  const Scratch folder;
  const auto table =
      schemes(folder,
              "carried_mass == 0.025 && lower_mass == 0.1 && (fast is lower) && (schedule is parallel) && "
              "(to_lower is lagrange4) && (to_upper is lagrange4)");
  ASSERT_EQ(table.size(), 1U);
  EXPECT_EQ(table[0].text("status"), "ok");
  EXPECT_EQ(table[0].text("order"), "");
  EXPECT_TRUE(table[0].text("note").starts_with("with half the steps it is failed: "))
      << table[0].text("note");
}

/// What the lower rod resists is the elbow's acceleration.
TEST(SplitPendulum, IsLostWithADisplacementThatHasNoAcceleration) {
  const Scratch folder;
  const auto table =
      schemes(folder,
              "lower_mass == 0.1 && carried_mass == 0 && (fast is lower) && (to_lower in [least_squares1_2, "
              "matched_hold])");
  ASSERT_EQ(table.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(table[k].text("status"), "lost") << k;
    EXPECT_EQ(table[k].text("order"), "") << k;
  }
}

/// A lag costs an order, and an error that grows with it; 1.6e-4 m is there without one, so the ratio of the
/// errors of ten small steps late and one is within 2.5 of 10.
TEST(SplitPendulum, ALateForceIsOfOrderOne) {
  const Scratch folder;
  const auto table = schemes(
      folder,
      "lower_mass == 0.1 && carried_mass == 0 && (schedule is fastest-first) && (to_lower is lagrange3) "
      "&& (lag in [memory, delay])");
  ASSERT_EQ(table.size(), 4U);  // lower: memory, delay; upper: memory, delay
  EXPECT_EQ(table[0].text("largest_error"), table[1].text("largest_error"))
      << "the reader's step is the communication step";
  EXPECT_NEAR(table[0].number("order"), 1.0, 0.2);
  EXPECT_NEAR(table[3].number("largest_error") / table[2].number("largest_error"), 10.0, 2.5);
}

/// As much mass below as above: what is felt of it at the elbow is up to three times what the upper rod has
/// there.
TEST(SplitPendulum, EqualMassesNeedAllOfTheLowerOneCarried) {
  const Scratch folder;
  const auto table =
      schemes(folder,
              "lower_mass == 1 && carried_mass != 0.25 && (schedule is slowest-first) && (to_lower "
              "is lagrange3) && (to_upper is lagrange1) && (fast is upper) && (lag is none)");
  ASSERT_EQ(table.size(), 2U);
  EXPECT_NE(table[0].text("status"), "ok");
  EXPECT_EQ(table[1].text("status"), "ok");
}

/// a_(n+1) = -mu (extrapolation of a_n, a_(n-1), .. by degree d): the root of alternating sign reaches -1 at
/// mu = 1/(2^(d+1) - 1). The rest is growth that 1000 steps do not show.
TEST(SplitPendulum, TheStableRatioOfMassesIsThatOfAnExtrapolatedAcceleration) {
  const Scratch folder;
  const auto table = swept(folder, "limits.toml", "limits",
                           "(formulation is null_space) && (fast is taker) && (schedule is fastest-first) && "
                           "(to_giver is lagrange3)");
  ASSERT_EQ(table.size(), 5U);
  for (std::size_t degree = 0; degree < 5; ++degree) {
    const double limit = 1.0 / (std::pow(2.0, static_cast<double>(degree) + 1.0) - 1.0);
    EXPECT_NEAR(table[degree].number("mass"), limit, 0.1 * limit) << degree;
  }
}

/// One step late, the force at the end of the step is its newest sample at any degree: a_(n+1) = -mu a_n.
TEST(SplitPendulum, TheStableRatioIsOneWithTheNewestAcceleration) {
  const Scratch folder;
  std::string study = test::read_text(scene + "limits.toml");
  for (const char* name : {"pair.toml", "swing.toml"})
    study.replace(study.find(std::string("\"") + name), 1, "\"" + scene);
  const auto late = study.find("name = \"limits_of_lags\""), ratio = study.find("ratio = [10]", late);
  study.replace(ratio, 12, "ratio = [1]");
  study.replace(study.find("[\"lagrange1\"]", late), 13, "[\"lagrange0\", \"lagrange2\", \"lagrange4\"]");
  folder.write("s.toml", study.substr(0, study.find("[[charts]]")));
  const Said said =
      tandem(folder, {"sweep", "s.toml", "--table", "limits_of_lags", "--output", "o", "--where",
                      "(formulation is null_space) && (fast is taker) && (schedule is fastest-first) && "
                      "(to_giver is lagrange3)"});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto table = CsvTable::read(folder.path() / "o/limits_of_lags.csv", {});
  ASSERT_EQ(table.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(table[k].number("mass"), 1.0, 0.1) << k;
}

}  // namespace
}  // namespace tandem::split_pendulum_tests
