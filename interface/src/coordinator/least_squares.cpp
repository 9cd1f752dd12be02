// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "link_rows.hpp"

namespace tandem {
namespace {

constexpr int max_points = 4 + 1 + 16;
constexpr int max_terms = 5;

/// The coefficient of (t' - t)^k of the fitted polynomial is the sum over i of w[k][i] y_i, i counted back
/// from the newest sample, at t.
struct Weights {
  int points = 0, terms = 0;
  std::array<std::array<double, max_points>, max_terms> w{};
};

/// Weights of the least-squares polynomial of degree terms - 1 in x through points x_0..x_{n-1}, by
/// orthogonal polynomials on the points (G. E. Forsythe, J. SIAM 5 (1957) 74): p_{k+1} = (x - a_k) p_k - b_k
/// p_{k-1}.
Weights fit(const std::array<double, max_points>& x, int n, int terms) {
  Weights fitted{n, terms};
  auto& w = fitted.w;
  std::array<double, max_points> p{}, before{};       // values of p_k and p_{k-1} at the points
  std::array<double, max_terms + 1> c{}, c_before{};  // their coefficients
  std::fill_n(p.begin(), n, 1.0);
  c[0] = 1.0;
  double norm_before = 1.0;
  for (int k = 0; k < terms; ++k) {
    double norm = 0.0, first_moment = 0.0;
    for (int i = 0; i < n; ++i) norm += p[i] * p[i], first_moment += x[i] * p[i] * p[i];
    for (int m = 0; m <= k; ++m)
      for (int i = 0; i < n; ++i) w[m][i] += c[m] * (p[i] / norm);
    const double a = first_moment / norm, b = k == 0 ? 0.0 : norm / norm_before;
    for (int i = 0; i < n; ++i) before[i] = (x[i] - a) * p[i] - b * before[i];
    for (int m = k + 1; m >= 0; --m) c_before[m] = (m > 0 ? c[m - 1] : 0.0) - a * c[m] - b * c_before[m];
    std::swap(p, before);
    std::swap(c, c_before);
    norm_before = norm;
  }
  return fitted;
}

struct Fit {
  std::int64_t stride;
  int degree, samples;

  Weights prepare(const double* row, std::int64_t fitted) const {
    const int n = static_cast<int>(std::min<std::int64_t>(samples, fitted + 1));
    const int terms = std::min(degree + 1, n);
    const double span = n > 1 ? row[0] - row[-(n - 1) * stride] : 1.0;
    std::array<double, max_points> x{};
    for (int i = 0; i < n; ++i)
      x[i] = (row[-i * stride] - row[0]) / span;  // in [-1, 0], for the sake of rounding
    Weights fitted_weights = fit(x, n, terms);
    double scale = 1.0;
    for (int k = 1; k < terms; ++k) {
      scale /= span;
      for (double& weight : fitted_weights.w[k]) weight *= scale;
    }
    return fitted_weights;
  }

  void fill(const Weights& weights, const double* row, const Lane& lane, double*, double* c) const {
    std::fill(c, c + max_terms, 0.0);
    for (int i = 0; i < weights.points; ++i) {
      const double y = lane.gain * row[Samples::header + lane.output - i * stride] + lane.offset;
      for (int k = 0; k < weights.terms; ++k) c[k] += weights.w[k][i] * y;
    }
  }
};

}  // namespace

void Link::extend_least_squares(Link& link, NewRows rows) {
  const Fit fit{link.stride_, link.how_.degree, link.how_.samples()};
  link.extend_rows(rows, fit, fit);
}

}  // namespace tandem
