// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

namespace tandem::test {

/// c0 + c1 t + c2 t^2 + ... and its derivatives.
struct Polynomial {
  std::vector<double> c;

  double operator()(double t) const {
    double v = 0.0;
    for (std::size_t k = c.size(); k-- > 0;) v = v * t + c[k];
    return v;
  }
  Polynomial derivative() const {
    Polynomial d;
    for (std::size_t k = 1; k < c.size(); ++k) d.c.push_back(static_cast<double>(k) * c[k]);
    return d;
  }
  /// One of that degree, with all coefficients different from 0.
  static Polynomial of_degree(int degree) {
    Polynomial p;
    for (int k = 0; k <= degree; ++k) p.c.push_back((k % 2 ? -1.0 : 1.0) * (1.0 + 0.5 * k));
    return p;
  }
};

}  // namespace tandem::test
