// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>

#include "tandem/mbs/integrators/integrator.hpp"

namespace tandem::mbs {

/// A problem x' = g(t, x).
class FirstOrder {
 public:
  virtual ~FirstOrder() = default;
  virtual int size() const = 0;
  /// rate becomes g(t, x); on entry it is a guess of that. Arrays of size().
  virtual void rates(double t, const double* x, double* rate) = 0;
};

/// A second-order problem as a first-order one in x = (y, y').
class AsFirstOrder final : public FirstOrder {
 public:
  explicit AsFirstOrder(SecondOrder& problem) : problem_(problem) {}
  int size() const override { return 2 * problem_.size(); }
  void rates(double t, const double* x, double* rate) override {
    const int n = problem_.size();
    std::copy_n(x + n, n, rate);
    problem_.accelerations(t, x, x + n, rate + n);
  }

 private:
  SecondOrder& problem_;
};

/// A first-order problem as a second-order one: x = y', so that y is the integral of x. By it Newmark's
/// method is the trapezoidal rule in x, whatever its beta.
class AsSecondOrder final : public SecondOrder {
 public:
  explicit AsSecondOrder(FirstOrder& problem) : problem_(problem) {}
  int size() const override { return problem_.size(); }
  void accelerations(double t, const double*, const double* v, double* a) override {
    problem_.rates(t, v, a);
  }

 private:
  FirstOrder& problem_;
};

}  // namespace tandem::mbs
