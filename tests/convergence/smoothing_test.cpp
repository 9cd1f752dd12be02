// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Mean over the receiver's step, and lags: what order they leave. Exact sides.
#include "expect_order.hpp"

namespace tandem::test {
namespace {

using enum Schedule::Kind;

// A mean stands for the value at the middle of the step to second order where the samples lie evenly about
// it. At a ratio that is not whole they do not, which is of first order a step, but its signs alternate and
// its sum stays bounded.
TEST(Mean, IsOfOrderTwoBesideAnyHigherDegree) {
  for (const double frequency_ratio : {2.5, 3.0, 7.3}) {
    TwoMassRun what = run_at(frequency_ratio, fastest_first);
    what.to_slow = "mean";
    for (const char* to_fast : {"lagrange1", "lagrange3", "lagrange4", "hermite", "least_squares3_2"}) {
      what.to_fast = to_fast;
      expect_order(what, 640, 2);
    }
    what.to_fast = "lagrange0";
    expect_order(what, 640, 1);
  }
}

// A lag is an error of its own length, whatever reconstructs.
TEST(Lag, OfMemoryOrDelayLeavesOrderOne) {
  for (const double frequency_ratio : {3.0, 7.3})
    for (const auto schedule : {slowest_first, fastest_first, parallel}) {
      TwoMassRun what = run_at(frequency_ratio, schedule);
      what.set_exact_sides(Crossing::force_from_fast);
      for (const Lag lag : {Lag::memory, Lag::delay}) {
        what.lag = lag;
        expect_order(what, 640, 1);
      }
    }
}

// The slow side's own step is the largest, so its memory is as long as the default communication step.
TEST(Lag, OfTheSlowSideIsTheSameByMemoryAsByDelay) {
  TwoMassRun what = run_at(7.3, slowest_first);
  what.set_exact_sides(Crossing::force_from_fast);
  what.lag = Lag::memory;
  const TwoMassResult memory = run(what);
  what.lag = Lag::delay;
  const TwoMassResult delay = run(what);
  EXPECT_EQ(memory.fast.back().x, delay.fast.back().x);
  EXPECT_EQ(memory.slow.back().x, delay.slow.back().x);
}

}  // namespace
}  // namespace tandem::test
