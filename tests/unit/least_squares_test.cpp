// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "link_bench.hpp"
#include "plain_fits.hpp"
#include "polynomial.hpp"

namespace tandem {
namespace {

using test::LinkBench;
using test::plain_least_squares;
using test::Polynomial;

/// Steps of 0.1 stretched by up to a half, 30 of them.
std::vector<double> uneven_nodes() {
  std::vector<double> nodes = {0.0};
  for (int k = 0; k < 30; ++k) nodes.push_back(nodes.back() + 0.1 + 0.05 * std::sin(5.0 * k));
  return nodes;
}

std::string least_squares(int degree, int extra) {
  return "least_squares" + std::to_string(degree) + "_" + std::to_string(extra);
}

double noisy(double t) { return std::sin(3.0 * t) + 0.1 * std::cos(50.0 * t); }

/// The fit that the rule asks for at t: the samples counted back from the first node at or after t, or the
/// newest.
double by_node_rule(const std::vector<double>& nodes, int degree, int extra, double t,
                    std::size_t oldest = 0) {
  std::size_t j = oldest;
  while (j + 1 < nodes.size() && nodes[j] < t) ++j;
  const auto count = static_cast<std::size_t>(degree + 1 + extra);
  const std::size_t first = std::max(oldest, j + 1 - std::min(j + 1, count));
  std::vector<double> x(nodes.begin() + static_cast<std::ptrdiff_t>(first),
                        nodes.begin() + static_cast<std::ptrdiff_t>(j + 1)),
      y;
  for (const double node : x) y.push_back(noisy(node));
  return plain_least_squares(x, y, std::min(degree, static_cast<int>(x.size()) - 1), t);
}

// Beyond the newest node by up to a step, a fit of degree 4 through 6 points magnifies rounding by its
// Lebesgue function, below 100; the values are about 1 and the weights take some 20 operations: 20 eps 100 =
// 4e-13, taken 10 times.
constexpr double fit_rounding = 4e-12;

TEST(LeastSquaresLink, IsThePlainFitOfTheNewestSamplesOfEachSegment) {
  const std::vector<double> nodes = uneven_nodes();
  for (int degree = 0; degree <= 4; ++degree)
    for (const int extra : {1, 2, 4, 16}) {
      LinkBench bench(least_squares(degree, extra));
      bench.give_all(nodes, noisy);
      const Signal signal = bench.read(0.0, 4.0);
      for (double t = 0.01; t < nodes.back() + 0.1; t += 0.0537)
        ASSERT_NEAR(signal.value(t), by_node_rule(nodes, degree, extra, t), fit_rounding)
            << degree << "_" << extra << " at " << t;
    }
}

TEST(LeastSquaresLink, IsExactForPolynomialsOfItsDegree) {
  const std::vector<double> nodes = uneven_nodes();
  for (int degree = 0; degree <= 4; ++degree)
    for (const int extra : {1, 4, 16}) {
      const Polynomial p = Polynomial::of_degree(degree);
      LinkBench bench(least_squares(degree, extra));
      bench.give_all(nodes, p);
      const Signal signal = bench.read(0.0, 4.0);
      for (double t = nodes[static_cast<std::size_t>(degree)]; t < nodes.back() + 0.1; t += 0.0537)
        ASSERT_NEAR(signal.value(t), p(t), 300.0 * fit_rounding)
            << degree << "_" << extra << " at " << t;  // |p| < 300 up to 3.2
    }
}

TEST(LeastSquaresLink, DiffersFromThePolynomialThroughTheNewestSamples) {
  LinkBench fitted("least_squares1_2"), through("lagrange1");
  for (const double t : {0.0, 1.0, 2.0, 3.0})
    for (LinkBench* bench : {&fitted, &through}) bench->give(t, t == 1.0 ? 1.0 : 0.0);
  // Fit of (0, 1, 0, 0) at x = 0..3: slope sum (x - 1.5) y / 5 = -0.1 about the mean 0.25 at 1.5; at 4 it is
  // 0.
  EXPECT_NEAR(fitted.read(3.0, 4.0).value(4.0), 0.0, 1e-15);
  EXPECT_NEAR(fitted.read(3.0, 4.0).value(3.5), 0.05, 1e-15);
  EXPECT_EQ(through.read(3.0, 4.0).value(3.5), 0.0);
}

TEST(LeastSquaresLink, FitsNothingAcrossAJump) {
  const std::vector<double> nodes = uneven_nodes();
  constexpr std::size_t jump = 12;
  for (int degree = 0; degree <= 4; ++degree) {
    LinkBench bench(least_squares(degree, 4));
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      if (k == jump) bench.give(nodes[k], 1e3);
      bench.give(nodes[k], noisy(nodes[k]), 0.0, 0.0, 0.0, k == jump);
    }
    const Signal signal = bench.read(0.0, 4.0);
    for (double t = nodes[jump] + 0.01; t < nodes.back() + 0.1; t += 0.0537)
      ASSERT_NEAR(signal.value(t), by_node_rule(nodes, degree, 4, t, jump), fit_rounding)
          << degree << " at " << t;
  }
}

}  // namespace
}  // namespace tandem
