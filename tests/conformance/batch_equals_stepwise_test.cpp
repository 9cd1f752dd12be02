// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Own steps that are taken in one call, one a call, or three a call give the same results to the last bit; so
// do runs that are repeated, or made at the same time.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>

#include "mass_pair.hpp"
#include "same_bits.hpp"

namespace tandem::test {
namespace {

/// With the roles swapped 1/0.7 is a ratio of 0.7.
const double ratios[] = {
    7.0, 30.0, 30.7, 100.0, 1.5, 1.0 / 0.7, std::numbers::sqrt2, 10.0 * std::numbers::pi};

/// The same run as it is and with each of the adapters, which take at most that many steps a call.
void expect_batch_equals_stepwise(MassPair what) {
  const auto expected = MassPairRun(what).run();
  const std::pair<Wrap, int> adapters[] = {{one_step_a_call, 1}, {three_samples_a_call, 3}};
  for (const auto& [wrap, steps] : adapters) {
    what.wrap = wrap;
    MassPairRun parts(what);
    EXPECT_TRUE(same_bits(parts.run(), expected)) << what.scheme.name() << " at " << what.frequency_ratio;
    for (const int who : {0, 1})
      EXPECT_LE(parts.bench().coordinator->effort(who).steps,
                steps * parts.bench().coordinator->effort(who).exchanges);
  }
}

class BatchEqualsStepwise : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Ratios, BatchEqualsStepwise, testing::ValuesIn(ratios), [](const auto& p) {
  return "FR" + std::to_string(static_cast<int>(100.0 * p.param)) + "hundredths";
});

TEST_P(BatchEqualsStepwise, ForEveryScheduleAndReconstruction) {
  for (const Scheme& scheme : all_schemes())
    expect_batch_equals_stepwise({.scheme = scheme, .frequency_ratio = GetParam()});
}

TEST_P(BatchEqualsStepwise, WithTheRolesOfFastAndSlowSwapped) {
  for (const Scheme& scheme : all_schemes()) {
    const bool has_mean = scheme.to_fast == "mean" || scheme.to_slow == "mean";
    const Scheme turned{scheme.schedule, has_mean ? scheme.to_slow : scheme.to_fast,
                        has_mean ? scheme.to_fast : scheme.to_slow};
    expect_batch_equals_stepwise({.scheme = turned, .frequency_ratio = GetParam(), .swapped = true});
  }
}

TEST_P(BatchEqualsStepwise, FromAnyStartTime) {
  for (const Scheme& scheme : all_schemes())
    expect_batch_equals_stepwise(
        {.scheme = scheme, .frequency_ratio = GetParam(), .t_start = -7.3, .t_stop = 5.0});
}

TEST_P(BatchEqualsStepwise, WithSubsystemsThatCompareTimesStrictly) {
  for (const Scheme& scheme : all_schemes())
    for (const double t_stop : {3.05, 0.3, 20.3}) {
      MassPair what{.scheme = scheme, .frequency_ratio = GetParam(), .t_stop = t_stop};
      const auto expected = MassPairRun(what).run();
      what.wrap = strict;
      EXPECT_TRUE(same_bits(MassPairRun(what).run(), expected)) << scheme.name() << " to " << t_stop;
    }
}

TEST_P(BatchEqualsStepwise, AfterEachKindOfStart) {
  for (const StartKind start : {StartKind::derivatives, StartKind::repeat, StartKind::cold})
    for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
      for (const char* how : {"lagrange3", "hermite", "least_squares2_4"})
        expect_batch_equals_stepwise(
            {.scheme = {schedule, how, how}, .frequency_ratio = GetParam(), .start = start});
}

TEST_P(BatchEqualsStepwise, WithAMemoryOrADelay) {
  for (const Lag lag : {Lag::memory, Lag::delay})
    for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
      for (const char* how : {"lagrange0", "lagrange3", "hermite", "least_squares2_4"})
        expect_batch_equals_stepwise(
            {.scheme = {schedule, how, how}, .frequency_ratio = GetParam(), .lag_to_slow = lag});
}

/// Mass 2 between two copies of mass 1 with other steps, each of which pulls by half; the sums have breaks of
/// both.
std::vector<Recording::Rows> three_masses(const Scheme& scheme, const Wrap& wrap) {
  two_mass::Settings settings;
  settings.frequency_ratio = 7.0;
  settings.phase1 = 0.8;
  const two_mass::Model model(settings);
  settings.steps_per_cycle = 61.3;
  const two_mass::Model coarser(settings);
  const auto one = wrap(std::make_unique<FixedStep<two_mass::FastMass>>(two_mass::FastMass(model, {})));
  const auto other = wrap(std::make_unique<FixedStep<two_mass::FastMass>>(two_mass::FastMass(coarser, {})));
  const auto slow = wrap(std::make_unique<FixedStep<two_mass::SlowMass>>(two_mass::SlowMass(model, {})));
  RunBench bench;
  bench.add("one", *one).add("other", *other).add("slow", *slow).schedule(scheme.schedule);
  bench.connect("slow.x2", "one.x2", scheme.to_fast).connect("slow.x2", "other.x2", scheme.to_fast);
  for (const char* from : {"one.x1", "other.x1"}) {
    Connection half = added(connection(from, "slow.x1", scheme.to_slow));
    half.gain = 0.5;
    bench.topology.connect(half);
  }
  return bench.run(10.03).all();
}

TEST(BatchEqualsStepwiseOfThree, ForEveryScheduleAndReconstruction) {
  for (const Scheme& scheme : all_schemes()) {
    if (scheme.schedule == "staggered") continue;
    const auto expected = three_masses(scheme, as_it_is);
    EXPECT_TRUE(same_bits(three_masses(scheme, one_step_a_call), expected)) << scheme.name();
    EXPECT_TRUE(same_bits(three_masses(scheme, three_samples_a_call), expected)) << scheme.name();
  }
}

TEST(Repeatability, TheSameRunGivesTheSameBits) {
  for (const Scheme& scheme : all_schemes()) {
    const MassPair what{.scheme = scheme, .frequency_ratio = 30.7};
    EXPECT_TRUE(same_bits(MassPairRun(what).run(), MassPairRun(what).run())) << scheme.name();
  }
}

TEST(Repeatability, RunsInTwoThreadsAtOnceGiveTheSameBits) {
  for (const Scheme& scheme : all_schemes()) {
    const MassPair a{.scheme = scheme, .frequency_ratio = 30.7}, b{.scheme = scheme, .frequency_ratio = 7.0};
    MassPairRun here(a), there(b);
    std::thread other([&] { there.run(); });
    here.run();
    other.join();
    EXPECT_TRUE(same_bits(here.bench().recording.all(), MassPairRun(a).run())) << scheme.name();
    EXPECT_TRUE(same_bits(there.bench().recording.all(), MassPairRun(b).run())) << scheme.name();
  }
}

}  // namespace
}  // namespace tandem::test
