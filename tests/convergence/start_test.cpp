// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What each start costs or saves. Exact sides; an exact past is a run that begins earlier and follows the
// exact motion up to t = 0.
#include "expect_order.hpp"

namespace tandem::test {
namespace {

using enum Schedule::Kind;

TwoMassRun started(Schedule::Kind schedule, StartKind start, const std::string& scheme) {
  TwoMassRun what = run_at(3.0, schedule);
  what.start = start;
  what.set_scheme(scheme);
  return what;
}

/// Sides that give so many true derivatives of their displacements, and say that they give three.
void set_true_derivatives(TwoMassRun& what, int count) {
  what.fast = exact({.fast = true, .derivatives = 3, .true_derivatives = count});
  what.slow = exact({.fast = false, .derivatives = 3, .true_derivatives = count});
}

class Start : public testing::TestWithParam<Schedule::Kind> {};

// Until it has samples enough a leader extrapolates a constant, then a straight line, ...: an error of H in
// the input for a time of H, so of H^2 in the state, for good.
TEST_P(Start, ColdCapsTheOrderAtTwo) {
  for (const char* scheme : {"lagrange2", "lagrange3", "lagrange4", "least_squares3_2"})
    expect_order(started(GetParam(), StartKind::cold, scheme), 320, 2);
}

// Its first segment is a tangent, so one order more.
TEST_P(Start, ColdCapsTheOrderOfHermiteAtThree) {
  expect_order(started(GetParam(), StartKind::cold, "hermite"), 160, 3);
}

TEST_P(Start, ByDegreeMinusOneDerivativesReachesTheFullOrder) {
  for (int degree = 2; degree <= 4; ++degree) {
    TwoMassRun what = started(GetParam(), StartKind::derivatives, "lagrange" + std::to_string(degree));
    set_true_derivatives(what, degree - 1);
    expect_order(what, 160, degree + 1);
  }
}

TEST_P(Start, ByDerivativesOfHermiteNeedsTwoOfThem) {
  TwoMassRun what = started(GetParam(), StartKind::derivatives, "hermite");
  set_true_derivatives(what, 2);
  expect_order(what, 160, 4);
}

TEST_P(Start, RepeatedReachesTheFullOrder) {
  for (int degree = 2; degree <= 4; ++degree)
    expect_order(started(GetParam(), StartKind::repeat, "lagrange" + std::to_string(degree)), 160,
                 degree + 1);
  expect_order(started(GetParam(), StartKind::repeat, "hermite"), 160, 4);
}

// No derivatives of F are given, so `automatic` repeats. F follows x2 at once, which costs a pass more.
TEST_P(Start, RepeatedReachesTheFullOrderOfAForceCoupling) {
  for (const Crossing crossing : {Crossing::force_from_fast, Crossing::force_from_slow})
    for (int degree = 2; degree <= 4; ++degree) {
      TwoMassRun what = started(GetParam(), StartKind::automatic, "lagrange" + std::to_string(degree));
      what.set_exact_sides(crossing);
      expect_order(what, 320, degree + 1);
    }
}

// At 160 steps per cycle; the two start with other samples, so not the same to a factor of 1.5.
TEST_P(Start, RepeatedIsAsGoodAsAnExactPast) {
  for (const Crossing crossing : {Crossing::displacements, Crossing::force_from_fast})
    for (int degree = 2; degree <= 4; ++degree) {
      TwoMassRun what = started(GetParam(), StartKind::repeat, "lagrange" + std::to_string(degree));
      what.settings.steps_per_cycle = 160;
      what.set_exact_sides(crossing);
      const GlobalError repeated = error_of(run(what));
      what.start = StartKind::cold;
      what.t_start = -(degree + 1) * what.settings.frequency_ratio / what.settings.steps_per_cycle;
      what.set_exact_sides(crossing, 1e-9);
      const GlobalError exact_past = error_of(run(what));
      EXPECT_LT(repeated.fast, 1.5 * exact_past.fast) << "degree " << degree;
      EXPECT_LT(repeated.slow, 1.5 * exact_past.slow) << "degree " << degree;
    }
}

// Orders 2 and 4 at 640 steps per cycle: measured 4400 slowest-first, 13 000 fastest-first and parallel.
TEST_P(Start, ColdIsThousandsOfTimesWorseAtDegreeThree) {
  TwoMassRun what = started(GetParam(), StartKind::cold, "lagrange3");
  what.settings.steps_per_cycle = 640;
  const double cold = error_of(run(what)).fast;
  what.start = StartKind::derivatives;
  EXPECT_GT(cold / error_of(run(what)).fast, 2000.0);
}

INSTANTIATE_TEST_SUITE_P(Exact, Start, testing::Values(slowest_first, fastest_first, parallel),
                         [](const auto& schedule) {
                           std::string name(Schedule::name(schedule.param));
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

// Seen slowest-first, where x1 with its fast mode is what is extrapolated. (In the others x2 is, whose higher
// derivatives are so small that the order drops only at steps 100 times finer.)
TEST(DerivativeStart, ByOneDerivativeFewerLosesAnOrder) {
  for (int degree = 2; degree <= 4; ++degree) {
    TwoMassRun what = started(slowest_first, StartKind::derivatives, "lagrange" + std::to_string(degree));
    set_true_derivatives(what, degree - 2);
    expect_order(what, 640, degree);
  }
}

// One way only: the slow side follows its exact motion, the fast side reads it. Slowest-first it
// interpolates, and the first segment, a straight line between the first two samples, errs by H^2 for a time
// of H.
TEST(ColdStart, CapsTheOrderAtThreeWhereItIsInterpolated) {
  TwoMassRun what = run_at(3.0, slowest_first);
  what.slow = exact({.fast = false, .exact_until = 1e300});
  for (const char* scheme : {"lagrange2", "lagrange3", "lagrange4"}) {
    what.set_scheme(scheme);
    what.start = StartKind::cold;
    expect_order_of_x1(what, 320, 3);
  }
}

}  // namespace
}  // namespace tandem::test
