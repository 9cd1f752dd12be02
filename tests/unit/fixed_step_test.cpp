// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/fixed_step.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "polynomial.hpp"
#include "refusal.hpp"

namespace tandem {
namespace {

using test::Polynomial;

/// x' = u, x(t_start) = 0, by Simpson's rule, which is exact for a cubic u; outputs x and the number of
/// steps.
struct Integral {
  double x = 0.0, steps = 0.0, last_length = 0.0;
  SubsystemInfo info() const {
    return {"integral", {{"u", "1"}}, {{"x", "s"}, {"steps", "1"}}, {}, {.serializes_state = true}};
  }
  double own_step() const { return 0.1; }
  void start(double, std::span<const double>) { *this = {}; }
  void step(const OwnStep& s, std::span<const Signal> u) {
    const double middle = s.begin + s.length / 2.0;
    x += s.length / 6.0 * (u[0].value(s.begin) + 4.0 * u[0].value(middle) + u[0].value(s.end));
    ++steps;
    last_length = s.length;
  }
  void outputs(double* y) const { y[0] = x, y[1] = steps; }
  void write(ByteWriter& to) const { to.put_doubles(std::array{x, steps}); }
  void read(ByteReader& from) { x = from.take<double>(), steps = from.take<double>(); }
};

class FixedStepTest : public testing::Test {
 protected:
  FixedStepTest() { clock = subsystem.initialize(t_start, 10.0, u0_, first_); }

  /// One call with room for that many rows; the rows end up in `y`.
  Clock advance(double t_limit, bool land, std::int64_t room = 100) {
    memory_.assign(static_cast<std::size_t>(room * subsystem.info().row_size()), 0.0);
    y = Samples(memory_.data(), subsystem.info().row_size(), room);
    return clock = subsystem.advance(t_limit, land, {&u_, 1}, y);
  }
  static double exact(double t) { return t * t * t * t - t_start * t_start * t_start * t_start; }

  static constexpr double t_start = 0.5;
  FixedStep<Integral> subsystem{Integral{}};
  Clock clock{};
  Samples y;

 private:
  Segment cubic_{1e9, 0.0, {0.0, 0.0, 0.0, 4.0}};  // u = 4 t^3
  Signal u_{&cubic_, 1, 3};
  double u0_[1] = {0.5};
  double row_[4] = {};
  Samples first_{row_, 4, 1};
  std::vector<double> memory_;
};

// x reaches 16 in 15 steps, each with a few roundings of eps/2 * 16.
constexpr double rounding = 100 * 2.2e-16 * 16.0;

TEST_F(FixedStepTest, StandsAtTheStart) {
  EXPECT_EQ(clock.time, t_start);
  EXPECT_EQ(clock.next_time, t_start + 0.1);
  EXPECT_EQ(clock.stop, Stop::limit);
}

TEST_F(FixedStepTest, TakesAllTheStepsThatFitAndOneSampleForEach) {
  advance(1.25, false);
  ASSERT_EQ(y.size(), 7);
  for (int k = 0; k < 7; ++k) {
    EXPECT_EQ(y.time(k), t_start + (k + 1) * 0.1);
    EXPECT_NEAR(y.values(k)[0], exact(y.time(k)), rounding);
    EXPECT_EQ(y.values(k)[1], k + 1);
  }
  EXPECT_EQ(clock.time, t_start + 7 * 0.1);
  EXPECT_EQ(clock.next_time, t_start + 8 * 0.1);
  EXPECT_EQ(clock.stop, Stop::limit);
}

TEST_F(FixedStepTest, TakesNoneIfNoneFits) {
  advance(0.55, false);
  EXPECT_EQ(y.size(), 0);
  EXPECT_EQ(clock.time, t_start);
}

TEST_F(FixedStepTest, LandsByACutStepAndKeepsItsGrid) {
  advance(1.25, true);
  ASSERT_EQ(y.size(), 8);
  EXPECT_EQ(clock.time, 1.25);
  EXPECT_NEAR(y.values(7)[0], exact(1.25), rounding);
  EXPECT_EQ(clock.next_time, t_start + 8 * 0.1);
  EXPECT_NEAR(subsystem.model().last_length, 0.05, 1e-15);
  advance(2.0, false);
  EXPECT_EQ(y.time(0), t_start + 8 * 0.1);
  EXPECT_EQ(clock.time, t_start + 15 * 0.1);
  EXPECT_EQ(subsystem.model().last_length, 0.1);
  EXPECT_NEAR(y.values(7)[0], exact(2.0), rounding);
}

TEST_F(FixedStepTest, LandingOnANodeTakesTheWholeStep) {
  advance(0.8, true);  // 0.5 + 3 * 0.1 is one ulp above 0.8
  EXPECT_EQ(y.size(), 3);
  EXPECT_EQ(clock.time, t_start + 3 * 0.1);
  EXPECT_EQ(subsystem.model().last_length, 0.1);
}

TEST_F(FixedStepTest, ReturnsEarlyWhenSamplesAreFullAndGoesOn) {
  advance(1.25, true, 3);
  EXPECT_EQ(clock.stop, Stop::samples_full);
  EXPECT_EQ(clock.time, t_start + 3 * 0.1);
  EXPECT_EQ(advance(1.25, true, 3).time, t_start + 6 * 0.1);
  EXPECT_EQ(advance(1.25, true, 3).stop, Stop::limit);
  EXPECT_EQ(clock.time, 1.25);
  const double in_three_calls = subsystem.model().x;
  FixedStepTest::subsystem = FixedStep<Integral>(Integral{});
  double row[4], u0[1] = {0.5};
  Samples first(row, 4, 1);
  subsystem.initialize(t_start, 10.0, u0, first);
  advance(1.25, true);
  EXPECT_EQ(subsystem.model().x, in_three_calls);
}

TEST_F(FixedStepTest, RestoresASavedStateBitForBit) {
  advance(1.0, false);
  const StateId id = subsystem.save_state();
  advance(1.33, true);
  const double x = subsystem.model().x;
  for (int again = 0; again < 2; ++again) {
    clock = subsystem.restore_state(id);
    EXPECT_EQ(clock.time, t_start + 5 * 0.1);
    EXPECT_EQ(clock.next_time, t_start + 6 * 0.1);
    advance(1.33, true);
    EXPECT_EQ(clock.time, 1.33);
    EXPECT_EQ(subsystem.model().x, x);
  }
  subsystem.release_state(id);
}

TEST_F(FixedStepTest, RefusesAStateThatWasNeverSavedOrIsReleased) {
  const StateId id = subsystem.save_state();
  subsystem.release_state(id);
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"integral"}, [&] { subsystem.restore_state(id); }));
}

TEST_F(FixedStepTest, AStateGoesAsBytesToAnotherInstance) {
  advance(1.33, true);  // off its grid
  const auto bytes = subsystem.serialize_state(subsystem.save_state());
  const auto started = [&](double t) {
    FixedStep<Integral> other{Integral{}};
    double row[4], u0[1] = {0.5};
    Samples first(row, 4, 1);
    other.initialize(t, 10.0, u0, first);
    return other;
  };
  auto other = started(t_start);
  const Clock there = other.restore_state(other.deserialize_state(bytes));
  EXPECT_EQ(there.time, 1.33);
  EXPECT_EQ(there.next_time, clock.next_time);
  EXPECT_EQ(other.model().x, subsystem.model().x);
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"integral", "0.1 s from", "allowed are those of"},
                            [&] { started(0.7).deserialize_state(bytes); }));
}

TEST(FixedStep, AddsTheAbilitiesThatItGives) {
  const FixedStep<Integral> subsystem{Integral{}};
  EXPECT_TRUE(subsystem.info().abilities.lands);
  EXPECT_TRUE(subsystem.info().abilities.restarts);
  EXPECT_TRUE(subsystem.info().abilities.saves_state);
  EXPECT_FALSE(subsystem.info().abilities.chooses_step);
}

/// The same to its third step, and without copies.
struct Ending : Integral {
  bool finished() const { return steps >= 3.0; }
  bool keeps_state() const { return false; }
};

TEST(FixedStep, AModelMayComeToItsEnd) {
  FixedStep<Ending> subsystem{Ending{}};
  const Segment zero{1e9, 0.0, {}};
  const Signal u(&zero, 1, 0);
  double rows[40];
  const double u0 = 0.0;
  Samples first(rows, 4, 1), y(rows, 4, 10);
  subsystem.initialize(0.0, 10.0, {&u0, 1}, first);
  for (const int more : {3, 0}) {
    y.c_rows().size = 0;
    const Clock clock = subsystem.advance(5.0, false, {&u, 1}, y);
    EXPECT_EQ(clock.stop, Stop::finished);
    EXPECT_EQ(clock.time, 3 * 0.1);
    EXPECT_EQ(y.size(), more);
  }
}

TEST(FixedStep, AModelThatIsNotKeptSavesNoState) {
  FixedStep<Ending> subsystem{Ending{}};
  EXPECT_FALSE(subsystem.info().abilities.saves_state);
  EXPECT_TRUE(test::refuses(ErrorCode::not_supported, {}, [&] { subsystem.save_state(); }));
  EXPECT_TRUE(test::refuses(ErrorCode::not_supported, {}, [&] { subsystem.restore_state(1); }));
  EXPECT_TRUE(test::refuses(ErrorCode::not_supported, {}, [&] { subsystem.release_state(1); }));
}

}  // namespace
}  // namespace tandem
