// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tandem::two_mass {

/// Least-squares fit of x(t) = a cos(w1 t) + b sin(w1 t) + c cos(w2 s) + d sin(w2 s), s = t - centre, by the
/// normal equations and Cholesky's factorization. Times centred on the data keep the slow mode's two columns
/// apart where they cover a small part of its cycle.
class ModeFit {
 public:
  /// Of mode 1: amplitude cos(w1 t + phase); and the root mean square of what the fit leaves over.
  struct Mode {
    double amplitude, phase, residual;
  };

  ModeFit(double omega1, double omega2, double centre) : omega1_(omega1), omega2_(omega2), centre_(centre) {}

  void add(double t, double x) {
    const Row row{std::cos(omega1_ * t), std::sin(omega1_ * t), std::cos(omega2_ * (t - centre_)),
                  std::sin(omega2_ * (t - centre_))};
    rows_.push_back(row);
    values_.push_back(x);
  }

  Mode solve() const {
    const Row c = coefficients();
    double squares = 0.0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      double rest = values_[k];
      for (std::size_t i = 0; i < 4; ++i) rest -= c[i] * rows_[k][i];
      squares += rest * rest;
    }
    return {std::hypot(c[0], c[1]), std::atan2(-c[1], c[0]),
            std::sqrt(squares / static_cast<double>(rows_.size()))};
  }

 private:
  using Row = std::array<double, 4>;

  Row coefficients() const {
    std::array<Row, 4> l{};  // lower triangle of N = A'A, then its Cholesky factor
    Row c{};
    for (std::size_t k = 0; k < rows_.size(); ++k)
      for (std::size_t i = 0; i < 4; ++i) {
        c[i] += rows_[k][i] * values_[k];
        for (std::size_t j = 0; j <= i; ++j) l[i][j] += rows_[k][i] * rows_[k][j];
      }
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        for (std::size_t m = 0; m < j; ++m) l[i][j] -= l[i][m] * l[j][m];
        l[i][j] = i == j ? std::sqrt(l[i][i]) : l[i][j] / l[j][j];
      }
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t m = 0; m < i; ++m) c[i] -= l[i][m] * c[m];
      c[i] /= l[i][i];
    }
    for (std::size_t i = 4; i-- > 0;) {
      for (std::size_t m = i + 1; m < 4; ++m) c[i] -= l[m][i] * c[m];
      c[i] /= l[i][i];
    }
    return c;
  }

  double omega1_, omega2_, centre_;
  std::vector<Row> rows_;
  std::vector<double> values_;
};

}  // namespace tandem::two_mass
