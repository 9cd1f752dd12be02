// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/link.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "link_bench.hpp"
#include "plain_fits.hpp"
#include "polynomial.hpp"

namespace tandem {
namespace {

using test::LinkBench;
using test::PlainLagrange;
using test::Polynomial;

constexpr double eps = std::numeric_limits<double>::epsilon();
const std::vector<double> node_times = {0.0, 0.3, 0.4, 0.8, 0.95, 1.0, 1.6, 2.0, 2.1, 2.5};

std::string lagrange(int degree) { return "lagrange" + std::to_string(degree); }

/// The polynomial that the node rule asks for at t, of rows from `oldest` on: through node_times j-d..j, j
/// the first node at or after t, or the newest. Before `oldest + d` it is of lower degree.
PlainLagrange by_node_rule(double (*f)(double), int degree, double t, std::size_t oldest = 0) {
  std::size_t j = oldest;
  while (j + 1 < node_times.size() && node_times[j] < t) ++j;
  const std::size_t first = std::max(oldest, j - std::min(j, static_cast<std::size_t>(degree)));
  std::vector<double> x, y;
  for (std::size_t k = first; k <= j; ++k) x.push_back(node_times[k]), y.push_back(f(node_times[k]));
  return {x, y, t};
}

double bounded(double t) { return std::sin(3.0 * t) + 0.3 * std::cos(11.0 * t); }

TEST(LagrangeLink, TakesTheNodesOfTheNodeRuleBetweenAndBeyondTheSamples) {
  for (int d = 0; d <= 4; ++d) {
    LinkBench bench(lagrange(d));
    bench.give_all(node_times, bounded);
    const Signal signal = bench.read(0.0, 3.0);
    for (double t = 0.0; t < 3.0; t += 1.0 / 64.0) {
      const PlainLagrange plain = by_node_rule(bounded, d, t);
      // Each divided difference and each of d nested multiplications rounds a few times.
      ASSERT_NEAR(signal.value(t), plain.value, 40.0 * eps * plain.lebesgue) << "degree " << d << " at " << t;
    }
  }
}

TEST(LagrangeLink, IsExactForPolynomialsOfItsDegree) {
  for (int d = 0; d <= 4; ++d) {
    const Polynomial p = Polynomial::of_degree(d);
    LinkBench bench(lagrange(d));
    bench.give_all(node_times, p);
    const Signal signal = bench.read(0.0, 3.0);
    for (double t = node_times[static_cast<std::size_t>(d)]; t < 3.0; t += 1.0 / 64.0) {
      const double size = 200.0 * by_node_rule(bounded, d, t).lebesgue;  // |p| < 200 up to t = 3
      ASSERT_NEAR(signal.value(t), p(t), 40.0 * eps * size) << "degree " << d << " at " << t;
      ASSERT_NEAR(signal.derivative(t), p.derivative()(t), 40.0 * eps * size * d * d / 0.05)
          << "Markov's inequality, steps of 0.05";
    }
  }
}

TEST(LagrangeLink, OfDegreeZeroGivesTheValueAtTheEndOfTheInterval) {
  LinkBench bench("lagrange0");
  bench.give(0.0, 10.0);
  bench.give(1.0, 11.0);
  bench.give(2.0, 12.0);
  const Signal signal = bench.read(0.0, 3.0);
  EXPECT_EQ(signal.value(0.5), 11.0);
  EXPECT_EQ(signal.value(1.5), 12.0);
  EXPECT_EQ(signal.value(2.5), 12.0);
}

TEST(LagrangeLink, ABreakBelongsToTheSegmentBeforeItWithinTheTolerance) {
  LinkBench bench("lagrange0");
  bench.give(0.0, 10.0);
  bench.give(1.0, 11.0);
  bench.give(2.0, 12.0);
  const Signal signal = bench.read(0.0, 3.0);
  EXPECT_EQ(signal.value(0.0), 10.0);
  EXPECT_EQ(signal.value(1.0), 11.0);
  EXPECT_EQ(signal.value(1.0 + 4.0 * eps), 11.0) << "the reader's node may differ by rounding";
  EXPECT_EQ(signal.value(1.0 + 8.0 * eps), 12.0);
}

TEST(LagrangeLink, ReadsTheSameBitsFromWhereverTheCallBegins) {
  for (int d = 0; d <= 4; ++d) {
    LinkBench whole(lagrange(d)), stepwise(lagrange(d));
    whole.give_all(node_times, bounded);
    stepwise.give_all(node_times, bounded);
    const Signal all = whole.read(0.0, 3.0);
    for (double t = 0.0; t < 2.9; t += 0.07)
      for (const double at : {t, t + 0.035, t + 0.07})
        ASSERT_EQ(stepwise.read(t, t + 0.07).value(at), all.value(at));
  }
}

TEST(LagrangeLink, FitsNothingAcrossAJump) {
  constexpr std::size_t jump = 4;
  for (int d = 0; d <= 4; ++d) {
    LinkBench bench(lagrange(d));
    for (std::size_t k = 0; k < node_times.size(); ++k) {
      if (k == jump) bench.give(node_times[k], -1e3);  // the value before the jump, at the same time
      bench.give(node_times[k], bounded(node_times[k]), 0.0, 0.0, 0.0, k == jump);
    }
    const Signal signal = bench.read(0.0, 3.0);
    EXPECT_EQ(signal.value(node_times[jump]), -1e3) << "the jump's own time belongs to what was before it";
    for (double t = node_times[jump] + 1.0 / 64.0; t < 3.0; t += 1.0 / 64.0) {
      const PlainLagrange plain = by_node_rule(bounded, d, t, jump);
      ASSERT_NEAR(signal.value(t), plain.value, 40.0 * eps * plain.lebesgue) << "degree " << d << " at " << t;
    }
  }
}

TEST(Link, ADelayShiftsTheSignal) {
  for (const char* how : {"lagrange0", "lagrange3", "hermite", "least_squares2_2"}) {
    const double delay = 0.25;
    LinkBench plain(how), delayed(how, delay);
    for (const double t : node_times)
      plain.give(t, bounded(t), 0.0, std::cos(t)), delayed.give(t, bounded(t), 0.0, std::cos(t));
    const Signal now = plain.read(0.0, 3.0), later = delayed.read(0.0, 3.0);
    for (double t = 0.0; t < 3.0; t += 1.0 / 128.0) {
      const PlainLagrange scale = by_node_rule(bounded, 3, t);
      if (std::find(node_times.begin(), node_times.end(), t) != node_times.end())
        continue;  // t + delay may round to the break's other side
      ASSERT_NEAR(later.value(t + delay), now.value(t), 1000.0 * eps * scale.lebesgue) << how << " at " << t;
    }
  }
}

TEST(Link, EachLaneHasItsOwnGainAndOffset) {
  for (const char* how :
       {"lagrange0", "lagrange1", "lagrange4", "hermite", "least_squares1_1", "mean", "matched_hold"}) {
    LinkBench bench(how, 0.0, {0, 0, 2.0, 3.0}, {1, 1, -1.0, 0.5});
    for (const double t : node_times) bench.give(t, 5.0 * t, 7.0 - t, 5.0, -1.0);
    const bool follows = Reconstruction::parse(how).follows_samples() && std::string(how) != "lagrange0";
    const Signal a = bench.read(2.4, 2.5, 0), b = bench.read(2.4, 2.5, 1);
    const double t = follows ? 2.45 : 2.5;  // a hold gives the newest sample
    EXPECT_NEAR(a.value(2.45), 2.0 * (5.0 * t) + 3.0, 1e-12)
        << how;  // 100 eps of 28, times a Lebesgue function below 30
    EXPECT_NEAR(b.value(2.45), -(7.0 - t) + 0.5, 1e-12) << how;
  }
}

TEST(Link, FollowsItsSourceIntoNewMemory) {
  for (const char* how : {"lagrange4", "hermite", "least_squares2_4"}) {
    LinkBench kept(how), moved(how);
    for (int k = 0; k < 31; ++k)
      for (LinkBench* bench : {&kept, &moved})
        bench->give(0.1 * k, bounded(0.1 * k), k, std::cos(0.1 * k), 1.0);
    for (const std::int64_t wanted : {5, 40}) {  // the same memory, then more
      moved.read(2.5, 2.6);
      moved.history().make_room(moved.link().oldest_needed(2.5), wanted);
      moved.link().follow_room();
    }
    EXPECT_GT(moved.history().oldest(), 10);
    for (LinkBench* bench : {&kept, &moved}) bench->give(3.1, bounded(3.1), 31.0, std::cos(3.1), 1.0);
    for (const std::size_t slot : {0U, 1U})
      for (double t = 2.5; t < 3.3; t += 0.03)
        ASSERT_EQ(moved.read(2.5, 3.3, slot).value(t), kept.read(2.5, 3.3, slot).value(t)) << how;
  }
}

TEST(Link, ReachesBackToTheStartWithItsFirstFullPolynomial) {
  const Polynomial p = Polynomial::of_degree(3);
  LinkBench bench("lagrange3");
  bench.give_all(node_times, p);
  EXPECT_GT(std::abs(bench.read(0.0, 1.0).value(0.2) - p(0.2)), 1e-3) << "or there is nothing to gain";
  bench.link().reach_back();
  const Signal signal = bench.read(0.0, 1.0);
  for (double t = 0.0; t < 3.0; t += 0.1)
    EXPECT_NEAR(signal.value(t), p(t), 1e-11) << t;  // as above: 40 eps 200 lebesgue
}

}  // namespace
}  // namespace tandem
