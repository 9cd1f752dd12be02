// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Figures that the rules of the coordinator are argued with.
#include <gtest/gtest.h>

#include "two_mass_run.hpp"

namespace tandem::test {
namespace {

using enum Schedule::Kind;

// A stored acceleration belongs to the old value of an input that has jumped since: 35 % instead of 1 % at FR
// 25, degree 0, slowest-first, 100 cycles. The input's value at the break is the jump's, so half of a step's
// push is wrong.
TEST(InputsThatJump, NeedTheAccelerationComputedAnew) {
  TwoMassRun what;
  what.settings.frequency_ratio = 25;
  what.t_stop = 100;
  what.set_scheme("lagrange0");
  what.fast = real_fast(), what.slow = real_slow();
  EXPECT_NEAR(position_error(run(what)), 0.011, 0.001);
  what.slow = reusing_slow();
  EXPECT_NEAR(position_error(run(what)), 0.35, 0.01);
}

TwoMassRun force_run(Crossing crossing, Schedule::Kind schedule) {
  TwoMassRun what = run_at(3.0, schedule);
  what.settings.steps_per_cycle = 500;
  what.set_exact_sides(crossing);
  return what;
}

// F = k2 (x1 - x2) given by the fast side at degree 3: 1.7e-8 m where it follows, 1.3e-7 m where it leads.
TEST(Feedthrough, BelongsToTheFollower) {
  const double following = error_of(run(force_run(Crossing::force_from_fast, slowest_first))).fast;
  const double leading = error_of(run(force_run(Crossing::force_from_fast, fastest_first))).fast;
  EXPECT_NEAR(following, 1.7e-8, 0.2e-8);
  EXPECT_NEAR(leading, 1.3e-7, 0.2e-7);
}

// The schedules differ without any force too (displacements: 5e-9 slowest-first, 1.3e-7 fastest-first), so
// the same at equal own steps, where either side may lead (its step is 1e-7 longer): given by the slow side F
// errs 2.8 times less where that side follows, though displacements alone favour the other order by 2.
TEST(Feedthrough, BelongsToTheFollowerAtEqualStepsToo) {
  using enum ExactMass::Coupling;
  const auto error = [](double fast_step, double slow_step) {
    TwoMassRun what = run_at(3.0, slowest_first);
    what.crossing = Crossing::force_from_slow;
    what.fast = exact({.fast = true, .coupling = reads_force, .own_step = fast_step});
    what.slow = exact({.fast = false, .coupling = gives_force, .own_step = slow_step});
    return error_of(run(what)).fast;
  };
  const double h = 0.005, longer = h * (1.0 + 1e-7);
  EXPECT_NEAR(error(h, longer) / error(longer, h), 2.8, 0.3);
}

// Which side owns the spring matters more than who leads: mass 1 hangs on k2 (k1 = 1e-3 k2), so reading F
// from across the coupling puts its own stiffness there. At FR 3 175 times slowest-first, 50 times
// fastest-first.
TEST(Feedthrough, BelongsWhereTheSpringIsStiff) {
  for (const auto schedule : {slowest_first, fastest_first}) {
    const double there = error_of(run(force_run(Crossing::force_from_fast, schedule))).fast;
    const double across = error_of(run(force_run(Crossing::force_from_slow, schedule))).fast;
    EXPECT_GT(across / there, 40.0) << Schedule::name(schedule);
  }
}

}  // namespace
}  // namespace tandem::test
