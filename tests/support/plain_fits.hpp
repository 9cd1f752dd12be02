// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace tandem::test {

/// Value and Lebesgue function at t of the polynomial through the points, term by term as Lagrange wrote it.
/// A rounding error eps in each value moves the polynomial at t by up to eps times the Lebesgue function.
struct PlainLagrange {
  double value = 0.0, lebesgue = 0.0;

  PlainLagrange(const std::vector<double>& x, const std::vector<double>& y, double t) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      double weight = 1.0;
      for (std::size_t k = 0; k < x.size(); ++k)
        if (k != i) weight *= (t - x[k]) / (x[i] - x[k]);
      value += weight * y[i];
      lebesgue += std::abs(weight);
    }
  }
};

/// Least-squares polynomial of that degree through the points, at t: the normal equations of the powers of x
/// - x.back(), solved by Gaussian elimination with pivoting, in extended precision.
inline double plain_least_squares(const std::vector<double>& x, const std::vector<double>& y, int degree,
                                  double t) {
  const auto n = static_cast<std::size_t>(degree + 1);
  std::vector<std::vector<long double>> a(n, std::vector<long double>(n + 1));
  for (std::size_t p = 0; p < x.size(); ++p)
    for (std::size_t r = 0; r < n; ++r) {
      const long double s = static_cast<long double>(x[p]) - x.back();
      for (std::size_t c = 0; c < n; ++c) a[r][c] += std::pow(s, static_cast<long double>(r + c));
      a[r][n] += std::pow(s, static_cast<long double>(r)) * y[p];
    }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t r = k; r < n; ++r)
      if (std::abs(a[r][k]) > std::abs(a[pivot][k])) pivot = r;
    std::swap(a[k], a[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == k) continue;
      const long double factor = a[r][k] / a[k][k];
      for (std::size_t c = k; c <= n; ++c) a[r][c] -= factor * a[k][c];
    }
  }
  long double value = 0.0L;
  for (std::size_t k = n; k-- > 0;)
    value = value * (static_cast<long double>(t) - x.back()) + a[k][n] / a[k][k];
  return static_cast<double>(value);
}

}  // namespace tandem::test
