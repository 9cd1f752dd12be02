// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "link_bench.hpp"
#include "polynomial.hpp"

namespace tandem {
namespace {

using test::LinkBench;
using test::Polynomial;

const std::vector<double> nodes = {0.0, 0.3, 0.4, 0.8, 1.5, 1.7};

void give(LinkBench& bench, const Polynomial& p, double t, bool jump = false) {
  bench.give(t, p(t), 2.0 * p(t), p.derivative()(t), 2.0 * p.derivative()(t), jump);
}

// |p| < 100 and |p'| < 100 up to t = 3; beyond the last step of 0.2 the cubic is evaluated at up to 6.5
// steps, which magnifies a rounding error by up to 6.5^3 * 10: below 1e-10.
constexpr double hermite_rounding = 1e-10;

TEST(HermiteLink, IsExactForCubicsBetweenAndBeyondTheSamples) {
  const Polynomial p = Polynomial::of_degree(3);
  LinkBench bench("hermite");
  for (const double t : nodes) give(bench, p, t);
  const Signal a = bench.read(0.0, 3.0, 0), b = bench.read(0.0, 3.0, 1);
  for (double t = 0.0; t < 3.0; t += 1.0 / 64.0) {
    EXPECT_NEAR(a.value(t), p(t), hermite_rounding) << t;
    EXPECT_NEAR(b.value(t), 2.0 * p(t), 2.0 * hermite_rounding) << t;
    EXPECT_NEAR(a.derivative(t), p.derivative()(t), 30.0 * hermite_rounding) << t;
  }
}

TEST(HermiteLink, MatchesValuesAndSlopesOfAnyDataAtBothEndsOfEachStep) {
  LinkBench bench("hermite");
  for (const double t : nodes) bench.give(t, std::sin(7.0 * t), 0.0, std::exp(t));
  const Signal signal = bench.read(0.0, 2.0);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    EXPECT_NEAR(signal.value(nodes[k]), std::sin(7.0 * nodes[k]), 1e-14);
    EXPECT_NEAR(signal.derivative(nodes[k]), std::exp(nodes[k]), 1e-13);
    if (k + 1 == nodes.size()) break;
    const double just_after =
        nodes[k] + 1e-12;  // in the next segment; its slope changes by up to 1e3 * 1e-12 there
    EXPECT_NEAR(signal.value(just_after), std::sin(7.0 * nodes[k]), 1e-10);
    EXPECT_NEAR(signal.derivative(just_after), std::exp(nodes[k]), 1e-8);
  }
}

TEST(HermiteLink, OfAFirstSampleIsItsTangent) {
  LinkBench bench("hermite");
  bench.give(1.0, 5.0, 0.0, 2.0);
  EXPECT_EQ(bench.read(1.0, 2.0).value(1.5), 6.0);
}

TEST(HermiteLink, StartsAgainWithTheTangentAfterAJump) {
  const Polynomial before = Polynomial::of_degree(3), after{{-50.0, 3.0, 0.0, 1.0}};
  LinkBench bench("hermite");
  for (const double t : {0.0, 0.3, 0.4}) give(bench, before, t);
  give(bench, after, 0.4, true);
  const double tangent = after(0.4) + 0.1 * after.derivative()(0.4);
  EXPECT_NEAR(bench.read(0.4, 0.5).value(0.5), tangent, hermite_rounding);
  for (const double t : {0.8, 1.5}) give(bench, after, t);
  const Signal signal = bench.read(0.0, 1.5);
  for (double t = 0.01; t < 0.4; t += 0.1) EXPECT_NEAR(signal.value(t), before(t), hermite_rounding) << t;
  EXPECT_NEAR(signal.value(0.4), before(0.4), hermite_rounding)
      << "the jump's own time belongs to what was before it";
  for (double t = 0.41; t < 2.0; t += 0.1) EXPECT_NEAR(signal.value(t), after(t), hermite_rounding) << t;
}

}  // namespace
}  // namespace tandem
