// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The mean force of an impulse coupling, and its pulse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "tandem/coordinator/impulse/defect_pulse.hpp"
#include "tandem/coordinator/impulse/force_window.hpp"
#include "tandem/coordinator/impulse/quadratic_map.hpp"

namespace tandem::test {
namespace {

using Kind = ForceWindow::Kind;

/// F = mean + ripple sin(w t), and its integrals from t = 0 on.
struct Force {
  double mean, ripple, w;
  double first(double t) const { return mean * t + ripple / w * (1.0 - std::cos(w * t)); }
  double second(double t) const { return mean * t * t / 2.0 + ripple / w * (t - std::sin(w * t) / w); }
  double third(double t) const {
    return mean * t * t * t / 6.0 + ripple / w * (t * t / 2.0 - (1.0 - std::cos(w * t)) / (w * w));
  }
  /// Of s alone, from the node t on.
  ForceIntegrals over(double t, double h) const {
    const double p = first(t), q = second(t);
    return {first(t + h) - p, second(t + h) - q - p * h, third(t + h) - third(t) - q * h - p * h * h / 2.0};
  }
};

/// As the text has it of equal steps, from sums that grow.
double by_sums(Kind kind, const Force& f, double h, int n) {
  const auto q = [&](int k) { return k > 0 ? f.second(k * h) : 0.0; };
  const auto u = [&](int k) { return k > 0 ? f.third(k * h) : 0.0; };
  const auto hat = [&](int k) { return (q(k + 1) - 2.0 * q(k) + q(k - 1)) / (h * h); };
  const auto spline = [&](int k) {
    return (u(k + 1) - 3.0 * u(k) + 3.0 * u(k - 1) - u(k - 2)) / (h * h * h);
  };
  if (kind == Kind::hat) return 1.5 * hat(n) - 0.5 * hat(n - 1);
  return (17.0 * spline(n) - 16.0 * spline(n - 1) + 5.0 * spline(n - 2)) / 6.0;
}

TEST(ForceWindow, OfEqualStepsIsADifferenceOfSums) {
  const Force f{1.5, 2.0, 7.3};
  const double h = 0.4;
  for (const Kind kind : {Kind::hat, Kind::b_spline}) {
    ForceWindow window(kind, h);
    for (int n = 0; n < 12; ++n)  // beyond that the sums lose digits
      EXPECT_NEAR(window.pass(f.over(n * h, h), h, h), by_sums(kind, f, h, n), 1e-11) << n;
  }
}

/// The impulse that is given never drifts from that of the force, whatever the steps.
TEST(ForceWindow, GivesTheWholeImpulseOfAnySteps) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> between(0.5, 1.5);
  const Force f{1.0, 3.0, 11.0};
  for (const Kind kind : {Kind::hat, Kind::b_spline}) {
    double h = between(random), t = 0.0, given = 0.0, largest = 0.0;
    ForceWindow window(kind, h);
    for (int n = 0; n < 10000; ++n) {
      const double next = between(random);
      given += h * window.pass(f.over(t, h), h, next);
      t += h, h = next;
      largest = std::max(largest, std::abs(given - f.first(t)));
    }
    EXPECT_LT(largest, 3.0) << "of " << f.first(t);
  }
}

/// By how much the double integral of a force is off that of its mean forces, at the nodes.
std::vector<double> defects(Kind kind, const Force& f, double h, int nodes) {
  ForceWindow window(kind, h);
  std::vector<double> all;
  double x = 0.0, v = 0.0;
  for (int n = 0; n < nodes; ++n) {
    const double mean = window.pass(f.over(n * h, h), h, h);
    x += h * (v + h * mean / 2.0), v += h * mean;
    all.push_back(f.second((n + 1) * h) - x);
  }
  return all;
}

/// T the second difference of the double integral Q: d_(n+1) - 2 d_n + d_(n-1) = h^2 / 4 (T_n - 2 T_(n-1) + T_(n-2)), so
/// d_n = h^2 T_(n-1) / 4. It is bounded at every frequency, also where a step is a whole number of periods.
TEST(ForceWindow, LeavesAQuarterOfASecondDifferenceAtTheNodes) {
  constexpr double h = 0.4;
  for (const double turns : {0.03, 0.31, 0.5, 0.97, 1.0, 1.0001, 2.0, 3.7, 10.0, 123.4}) {
    const Force f{0.0, 3.0, 2.0 * std::numbers::pi * turns / h};
    const auto d = defects(Kind::hat, f, h, 400);
    for (int n = 3; n < 400; ++n) {
      const auto q = [&](int k) { return f.second(k * h); };
      const double t = (q(n - 1) - 2.0 * q(n - 2) + q(n - 3)) / (h * h);
      ASSERT_NEAR(d[static_cast<std::size_t>(n - 2)], h * h * t / 4.0, 1e-9) << turns << ' ' << n;
    }
  }
}

/// The other window leaves the ripple itself, and as little of it.
TEST(ForceWindow, LeavesNoMoreAfterManySteps) {
  constexpr double h = 0.4;
  const auto largest = [](const std::vector<double>& d, std::size_t from, std::size_t to) {
    double most = 0.0;
    for (std::size_t k = from; k < to; ++k) most = std::max(most, std::abs(d[k]));
    return most;
  };
  std::mt19937 random(26);
  std::uniform_real_distribution<double> any(std::log(0.01), std::log(100.0));
  for (int k = 0; k < 200; ++k) {
    const double turns = k < 20 ? k / 2.0 + 0.5 : std::exp(any(random));
    const Force f{0.0, 3.0, 2.0 * std::numbers::pi * turns / h};
    for (const Kind kind : {Kind::hat, Kind::b_spline}) {
      const auto d = defects(kind, f, h, 4000);
      EXPECT_LE(largest(d, 2000, 4000), 1.02 * largest(d, 0, 2000) + 1e-8) << turns;
    }
  }
}

/// A ripple of a whole period in five steps repeats, and so does its force; sums from the start would have lost it:
/// the third one is 1e14 then, of which a double has steps of 0.02.
TEST(ForceWindow, KeepsItsDigitsOverManySteps) {
  const double h = 1.0;
  const Force f{1.0, 1.0, 2.0 * std::numbers::pi * 3.0 / 5.0};
  for (const Kind kind : {Kind::hat, Kind::b_spline}) {
    ForceWindow window(kind, h);
    std::vector<double> all;
    for (int n = 0; n < 100000; ++n) all.push_back(window.pass(f.over((n % 5) * h, h), h, h));
    for (std::size_t n = 20; n < all.size(); ++n) ASSERT_NEAR(all[n], all[n % 5 + 15], 1e-13) << n;
  }
}

/// Of a force that changes slowly it is the mean over the step, to second order in its length.
TEST(ForceWindow, OfASlowForceIsItsMeanByOrder) {
  const Force f{0.0, 1.0, 1.0};
  const auto error = [&](Kind kind, double h) {
    ForceWindow window(kind, h);
    double worst = 0.0;
    for (int n = 0; n * h < 10.0; ++n) {
      const double force = window.pass(f.over(n * h, h), h, h);
      if (n * h > 2.0)
        worst = std::max(worst, std::abs(force - (std::cos(n * h) - std::cos((n + 1) * h)) / h));
    }
    return worst;
  };
  for (const Kind kind : {Kind::hat, Kind::b_spline})
    EXPECT_NEAR(std::log2(error(kind, 0.05) / error(kind, 0.0125)) / 2.0, 2.0, 0.1);
}

TEST(DefectPulse, BeginsSmoothlyAndEndsAsTheFreeMotionOfItsDefect) {
  const DefectPulse pulse(0.3, -0.7, 2.5);
  EXPECT_EQ(pulse.value(0.0), 0.0);
  EXPECT_EQ(pulse.rate(0.0), 0.0);
  EXPECT_EQ(pulse.acceleration(0.0), 0.0);
  EXPECT_NEAR(pulse.value(2.5), 0.3 - 0.7 * 2.5, 1e-14);
  EXPECT_NEAR(pulse.rate(2.5), -0.7, 1e-14);
  EXPECT_NEAR(pulse.acceleration(2.5), 0.0, 1e-14);
  EXPECT_NEAR(pulse.free(4.0), 0.3 - 0.7 * 4.0, 1e-14);
  for (const double s : {0.4, 1.7}) {
    EXPECT_NEAR((pulse.value(s + 1e-6) - pulse.value(s - 1e-6)) / 2e-6, pulse.rate(s), 1e-8);
    EXPECT_NEAR((pulse.rate(s + 1e-6) - pulse.rate(s - 1e-6)) / 2e-6, pulse.acceleration(s), 1e-8);
  }
}

/// Exact for a quadratic; its rest is of third order otherwise.
TEST(QuadraticMap, IsTheTaylorPolynomialOfSecondOrder) {
  const auto quadratic = [](std::span<const double> x, std::span<double> y) {
    y[0] = 1.0 + 2.0 * x[0] - 3.0 * x[2] + 0.5 * x[0] * x[0] + 4.0 * x[0] * x[1] - 7.0 * x[1] * x[2];
    y[1] = x[2] * x[2] - x[1];
  };
  const auto curved = [](std::span<const double> x, std::span<double> y) {
    y[0] = std::exp(x[0] - x[1]) * std::cos(x[2]), y[1] = std::sin(x[0] * x[1] + x[2]);
  };
  std::vector<double> x = {0.3, -0.6, 0.2}, y(2), exact(2);
  const std::vector<double> steps(3, 1e-4);
  const auto off = [&](const auto& f, double size) {
    QuadraticMap map(3, 2);
    map.expand(x, steps, f);
    const std::vector<double> d = {size, -0.7 * size, 0.4 * size};
    map.values(d, y);
    f(std::vector<double>{x[0] + d[0], x[1] + d[1], x[2] + d[2]}, exact);
    return std::hypot(y[0] - exact[0], y[1] - exact[1]);
  };
  EXPECT_LT(off(quadratic, 2.0), 1e-6);
  EXPECT_NEAR(std::log2(off(curved, 0.04) / off(curved, 0.02)), 3.0, 0.1);
}

}  // namespace
}  // namespace tandem::test
