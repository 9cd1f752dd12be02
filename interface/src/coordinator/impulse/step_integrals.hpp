// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

#include "tandem/bytes.hpp"
#include "tandem/coordinator/impulse/force_window.hpp"

namespace tandem {

/// A cubic through two values with their rates, at x of a step h long, 0 <= x <= 1.
inline double hermite(double h, double x, double y0, double d0, double y1, double d1) {
  const double u = 1.0 - x;
  return u * u * ((1.0 + 2.0 * x) * y0 + x * h * d0) + x * x * ((1.0 + 2.0 * u) * y1 - u * h * d1);
}

/// The first three integrals of a force, or of an acceleration, from the slow side's last node on.
class StepIntegrals {
 public:
  /// Over an own step, so long [s]: the force at its begin, middle and end.
  void step(double h, const double (&f)[3]) {
    before_ = sum_;
    sum_.third += h * (before_.second + h * (before_.first / 2.0 + h * (f[0] + f[1]) / 12.0));
    sum_.second += h * (before_.first + h * (f[0] + 2.0 * f[1]) / 6.0);
    sum_.first += h * (f[0] + 4.0 * f[1] + f[2]) / 6.0;
  }
  const ForceIntegrals& now() const { return sum_; }
  /// Another own step has brought them here.
  void go_to(const ForceIntegrals& now) { before_ = sum_, sum_ = now; }
  void add(const ForceIntegrals& more) {
    sum_.first += more.first, sum_.second += more.second, sum_.third += more.third;
  }
  /// The node lies in the last step, h long, s before its end, with the force at its begin and end: the integrals up to
  /// there. From here on they count from that node.
  ForceIntegrals cut_at_node(double h, double s, double force_before, double force_now) {
    const double x = (h - s) / h;
    const ForceIntegrals node{hermite(h, x, before_.first, force_before, sum_.first, force_now),
                              hermite(h, x, before_.second, before_.first, sum_.second, sum_.first),
                              hermite(h, x, before_.third, before_.second, sum_.third, sum_.second)};
    sum_.third -= node.third + s * (node.second + s * node.first / 2.0);
    sum_.second -= node.second + s * node.first;
    sum_.first -= node.first;
    return node;
  }

  std::array<double*, 6> numbers() {
    return {&sum_.first, &sum_.second, &sum_.third, &before_.first, &before_.second, &before_.third};
  }

  void write(ByteWriter& to) const {
    for (const ForceIntegrals* one : {&sum_, &before_})
      to.put(one->first), to.put(one->second), to.put(one->third);
  }
  void read(ByteReader& from) {
    for (double* one : numbers()) *one = from.take<double>();
  }

 private:
  ForceIntegrals sum_, before_;  ///< now; at the begin of the last own step
};

/// What the first steps missed of a force, per unit of what they missed at their end. The polynomials of steps n and n + 1
/// differ by binomial(t / h, n) times that; its integrals from 0 to n.
inline ForceIntegrals missed_at_start(int steps, double h) {
  constexpr ForceIntegrals of[] = {{1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0},
                                   {1.0 / 3.0, 0.0, -1.0 / 15.0},
                                   {3.0 / 8.0, 3.0 / 20.0, 9.0 / 80.0},
                                   {14.0 / 45.0, 0.0, -8.0 / 63.0}};
  const ForceIntegrals& one = of[steps - 1];
  return {h * one.first, h * h * one.second, h * h * h * one.third};
}

}  // namespace tandem
