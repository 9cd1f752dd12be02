// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Matched hold keeps the energy of the states that each side last computed, whatever the spring, the schedule
// and the ratio.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nonlinear_masses.hpp"
#include "run_bench.hpp"
#include "word.hpp"

namespace tandem::test {
namespace {

/// The largest relative change of the energy of the states last computed, looked at after each turn.
class EnergyWatch final : public Observer {
 public:
  EnergyWatch(const NonlinearMass::Parameters& a, const NonlinearMass::Parameters& b)
      : a_(a), b_(b), x_{a.x0, b.x0}, v_{a.v0, b.v0}, start_(energy()) {}
  bool samples(int who, const History& h, std::int64_t, std::int64_t last) override {
    x_[who] = h.values(last)[0];
    v_[who] = h.values(last)[1];
    change_ = std::max(change_, std::abs(energy() / start_ - 1.0));
    return true;
  }
  double change() const { return change_; }

 private:
  double energy() const { return NonlinearMass::energy(a_, x_[0], v_[0], b_, x_[1], v_[1]); }
  NonlinearMass::Parameters a_, b_;
  double x_[2], v_[2], start_, change_ = 0.0;
};

/// A mass of 1 kg that swings at about 1 Hz and one of 40 kg; 20 s with steps h and ratio * h.
double energy_change(const std::string& schedule, const std::string& how, double h, double ratio) {
  const NonlinearMass::Parameters light{1.0, 30.0, 1.0, 0.5, h}, heavy{40.0, 10.0, -0.6, 0.2, h * ratio};
  FixedStep<NonlinearMass> fast{NonlinearMass(light)}, slow{NonlinearMass(heavy)};
  RunBench bench;
  bench.add("fast", fast)
      .add("slow", slow)
      .schedule(schedule)
      .connect("slow.x", "fast.u", how)
      .connect("fast.x", "slow.u", how);
  EnergyWatch watch(light, heavy);
  Coordinator& run = bench.make(20.0);
  run.observe(&watch);
  run.run();
  return watch.change();
}

const double hold_ratios[] = {1.0, 2.0, 2.5, 3.0, 7.0, 30.7, 5.0 * std::numbers::sqrt2, 100.0};

// w = 10 rad/s at the most (the spring hardens), so 20 s of small steps lose 1e4 (10 * 0.002)^6 / 144 * 2 =
// 1e-8 at most.
constexpr double integrators = 2e-8;

class MatchedHold : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Schedules, MatchedHold,
                         testing::Values("slowest-first", "fastest-first", "staggered"),
                         [](const auto& p) { return word(p.param); });

TEST_P(MatchedHold, KeepsTheEnergyOfANonlinearSpringAtAnyRatio) {
  for (const double ratio : hold_ratios)
    for (const double h : {0.05, 0.013})
      EXPECT_LT(energy_change(GetParam(), "matched_hold", h, ratio), integrators) << ratio;
}

TEST(Lagrange0, DoesNotKeepIt) {  // or the test above would show nothing
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const double ratio : {2.5, 7.0, 30.7})
      EXPECT_GT(energy_change(schedule, "lagrange0", 0.05, ratio), 1e-4) << schedule << ratio;
}

}  // namespace
}  // namespace tandem::test
