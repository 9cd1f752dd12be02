// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/history.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "polynomial.hpp"
#include "refusal.hpp"

namespace tandem {
namespace {

using test::Polynomial;
using test::refuses;

const TimeTolerance tolerance(1e3);  // a width of 9e-13

/// Two ports, the second an array of two, with as many derivatives of each.
SubsystemInfo info(int derivatives) {
  return {"pump", {}, {{"p", "Pa", 1, derivatives}, {"q", "m", 2, derivatives}}, {}, {}};
}

void append(History& h, double t, double first, double second = 0.0, double third = 0.0, bool jump = false) {
  double* y = h.room().append(t, jump);
  y[0] = first, y[1] = second, y[2] = third;
}

TEST(History, ShowsRowsOnceTheyAreCommitted) {
  const SubsystemInfo pump = info(0);
  History h("pump", pump, 32);
  EXPECT_TRUE(h.empty());
  append(h, 0.0, 1.0);
  append(h, 0.5, 2.0);
  EXPECT_TRUE(h.empty());
  h.commit(0.5, tolerance);
  EXPECT_EQ(h.newest(), 1);
  EXPECT_EQ(h.oldest(), 0);
  EXPECT_EQ(h.time(1), 0.5);
  EXPECT_EQ(h.values(1)[0], 2.0);
}

/// What commit says of one row after a good one at t = 1 with the limit 2.
testing::AssertionResult refuses_row(const std::vector<std::string>& texts, double t,
                                     std::vector<double> values, bool jump = false) {
  const SubsystemInfo pump = info(1);
  History h("pump", pump, 32);
  std::fill_n(h.room().append(1.0), 6, 0.0);
  h.commit(1.0, tolerance);
  values.resize(6);
  std::copy(values.begin(), values.end(), h.room().append(t, jump));
  return refuses(ErrorCode::numerical, texts, [&] { h.commit(2.0, tolerance); });
}

TEST(History, RefusesAJumpFlagThatIsNone) {
  for (const double flag : {0.5, 7.0, -1.0}) {
    const SubsystemInfo pump = info(0);
    History h("pump", pump, 32);
    append(h, 1.0, 0.0);
    append(h, 1.5, 0.0);
    h.room().c_rows().rows[5 + 1] = flag;
    EXPECT_TRUE(refuses(ErrorCode::numerical,
                        {"'pump'", " as the jump flag of its sample at t = 1.5 s", "0 or 1"},
                        [&] { h.commit(2.0, tolerance); }))
        << flag;
  }
}

TEST(History, RefusesValuesThatAreNotFiniteByPortAndTime) {
  EXPECT_TRUE(refuses_row({"subsystem 'pump', advance at t = 1 s to 2 s: it gave p not finite at t = 1.5"},
                          1.5, {NAN}));
  EXPECT_TRUE(refuses_row({"'pump'", "q[0]", "not finite"}, 1.5, {0.0, INFINITY}));
  EXPECT_TRUE(refuses_row({"q[1]"}, 1.5, {0.0, 0.0, -INFINITY}));
  EXPECT_TRUE(refuses_row({"q[1] (a derivative)"}, 1.5, {0.0, 0.0, 0.0, 0.0, 0.0, NAN}));
  EXPECT_TRUE(refuses_row({"a time", "not finite"}, NAN, {}));
}

TEST(History, RefusesTimesThatDoNotRiseOrPassTheLimit) {
  EXPECT_TRUE(refuses_row({"'pump'", "0.5", "does not come after"}, 0.5, {}));
  EXPECT_TRUE(refuses_row({"'pump'", "does not come after"}, 1.0, {}));
  EXPECT_TRUE(refuses_row({"does not come after"}, 0.5, {}, true)) << "not even across a jump";
  EXPECT_TRUE(refuses_row({"'pump'", "2.001", "past its limit 2"}, 2.001, {}));
}

TEST(History, RefusesTheFirstRowAsThatOfTheStart) {
  const SubsystemInfo pump = info(0);
  History h("pump", pump, 32);
  append(h, 1.0, NAN);
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"'pump', initialize: it gave p not finite"},
                      [&] { h.commit(1.0, tolerance); }));
}

TEST(History, NamesTimesOfAnySize) {
  EXPECT_TRUE(refuses_row({"3e-09"}, 3e-9, {NAN})) << "std::to_string would say 0.000000";
}

TEST(History, LetsAJumpRepeatATimeAndATimePassTheLimitByTheTolerance) {
  const SubsystemInfo pump = info(0);
  History h("pump", pump, 32);
  append(h, 1.0, 1.0);
  append(h, 1.0, 2.0, 0.0, 0.0, true);
  append(h, 2.0 + tolerance.width(2.0, 2.0) / 2.0, 3.0);
  EXPECT_NO_THROW(h.commit(2.0, tolerance));
  EXPECT_TRUE(h.jump(1));
  EXPECT_FALSE(h.jump(2));
}

TEST(History, LargeFiniteValuesPass) {
  const SubsystemInfo pump = info(0);
  History h("pump", pump, 32);
  append(h, 1.0, 1.7e308, -1.7e308, 5e-324);
  EXPECT_NO_THROW(h.commit(1.0, TimeTolerance()));
}

TEST(History, DroppingAndGrowingKeepRowsAndTheirNumbers) {
  const SubsystemInfo pump = info(0);
  History h("pump", pump, 0);
  EXPECT_EQ(h.capacity(), History::min_capacity);
  std::int64_t row = 0;
  for (int batch = 1; batch <= 60; ++batch) {  // larger and larger batches, of which the last 5 rows are kept
    h.make_room(h.newest() - 4, batch);
    ASSERT_TRUE(h.has_room(batch));
    for (int k = 0; k < batch; ++k, ++row)
      append(h, 0.1 * static_cast<double>(row), static_cast<double>(row));
    h.commit(1e9, TimeTolerance());
    ASSERT_EQ(h.newest(), row - 1);
    ASSERT_LE(h.oldest(), std::max<std::int64_t>(0, row - batch - 5));
    for (std::int64_t r = h.oldest(); r <= h.newest(); ++r) {
      ASSERT_EQ(h.values(r)[0], static_cast<double>(r));
      ASSERT_EQ(h.time(r), 0.1 * static_cast<double>(r));
    }
  }
}

TEST(History, MakingRoomKeepsRowsThatAreNotCommittedYet) {
  const SubsystemInfo pump = info(0);
  History h("pump", pump, 32);
  for (int k = 0; k < 30; ++k) append(h, k, k);
  h.commit(29.0, TimeTolerance());
  append(h, 30.0, 30.0);
  h.make_room(28, 10);
  h.commit(30.0, TimeTolerance());
  EXPECT_EQ(h.oldest(), 28);
  EXPECT_EQ(h.newest(), 30);
  EXPECT_EQ(h.values(30)[0], 30.0);
}

TEST(History, SeedsAreExactForPolynomialsOfTheDegreeOfTheDerivatives) {
  for (int d = 0; d <= 3; ++d) {
    const SubsystemInfo pump = info(d);
    const Polynomial p = Polynomial::of_degree(d);
    const double t0 = 2.0, h = 0.25;
    History history("pump", pump, 32);
    double* y = history.room().append(t0);
    Polynomial derivative = p;
    for (int m = 0; m <= d; ++m, derivative = derivative.derivative())
      for (int i = 0; i < 3; ++i) y[3 * m + i] = (i + 1) * derivative(t0);
    history.commit(t0, TimeTolerance());
    history.seed(6, h);
    ASSERT_TRUE(history.empty()) << "until they are committed";
    history.commit(t0, TimeTolerance());
    ASSERT_EQ(history.first_own(), 6);
    ASSERT_EQ(history.newest(), 6);
    for (std::int64_t row = 0; row <= 6; ++row) {
      const double t = t0 - static_cast<double>(6 - row) * h;
      EXPECT_EQ(history.time(row), t);
      derivative = p;
      for (int m = 0; m <= d; ++m, derivative = derivative.derivative())
        for (int i = 0; i < 3; ++i)  // terms up to 3 * 2.5 * 8 with a few roundings each
          EXPECT_NEAR(history.values(row)[static_cast<std::size_t>(3 * m + i)], (i + 1) * derivative(t),
                      1e-13);
    }
  }
}

TEST(History, ClearForgetsEverything) {
  const SubsystemInfo pump = info(0);
  History h("pump", pump, 32);
  append(h, 1.0, 1.0);
  h.commit(1.0, TimeTolerance());
  h.seed(3, 0.1);
  h.clear();
  EXPECT_TRUE(h.empty());
  EXPECT_EQ(h.first_own(), 0);
  append(h, 0.0, 5.0);
  h.commit(0.0, TimeTolerance());
  EXPECT_EQ(h.values(0)[0], 5.0);
}

}  // namespace
}  // namespace tandem
