// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Models whose inputs are driven by data, and what is exact of them.
#pragma once
#include <random>

#include "tandem/bytes.hpp"
#include "tandem/fixed_step.hpp"
#include "tandem/sampled.hpp"
#include "tandem/time_series.hpp"

namespace tandem::test {

/// x' = u by Simpson's rule, right for cubics; outputs x and y = x + u, which follows u at once.
class Integral {
 public:
  explicit Integral(double step) : step_(step) {}
  SubsystemInfo info() const {
    SubsystemInfo info{"integral", {{"u", "1"}}, {{"x", "1"}, {"y", "1"}}, {{1, 0}}, {}};
    info.abilities.serializes_state = true;
    return info;
  }
  double own_step() const { return step_; }
  void start(double, std::span<const double> u0) { x_ = 0.0, u_ = u0[0]; }
  void step(const OwnStep& s, std::span<const Signal> u) {
    x_ += s.length / 6.0 *
          (u[0].value(s.begin) + 4.0 * u[0].value(s.begin + s.length / 2.0) + u[0].value(s.end));
    u_ = u[0].value(s.end);
  }
  bool jump(double t, std::span<const Signal> u) {
    const double before = std::exchange(u_, u[0].value(t));
    return u_ != before;
  }
  void outputs(double* y) const { y[0] = x_, y[1] = x_ + u_; }
  void write(ByteWriter& to) const { to.put(x_), to.put(u_); }
  void read(ByteReader& from) { x_ = from.take<double>(), u_ = from.take<double>(); }

 private:
  double step_, x_ = 0.0, u_ = 0.0;
};

/// Gives at each instant what it reads there.
class Reading {
 public:
  explicit Reading(double period) : period_(period) {}
  SubsystemInfo info() const { return {"reading", {{"u", "1"}}, {{"u", "1"}}, {{0, 0}}, {}}; }
  double own_step() const { return period_; }
  void start(double, std::span<const double>) {}
  void step(const OwnStep&, std::span<const Signal>) {}
  void outputs(double* y) const { y[0] = 0.0; }
  void outputs(double* y, std::span<const double> u) const { y[0] = u[0]; }

 private:
  double period_;
};

/// The integral of a series from its first piece's begin to t.
inline double integral(const TimeSeries& series, double t) {
  double sum = 0.0;
  for (const Segment& s : series.pieces()) {
    if (s.origin >= t) break;
    const double h = std::min(s.end, t) - s.origin;
    sum += h * (s.c[0] + h * (s.c[1] / 2.0 + h * (s.c[2] / 3.0 + h * s.c[3] / 4.0)));
  }
  return sum;
}

/// Points over 1 s from `start` on, at distances of 0.02 to 0.1 s; but for splines a quarter of them jumps.
inline TimeSeries random_series(std::mt19937& random, TimeSeries::How how, double start) {
  std::uniform_real_distribution<double> gap(0.02, 0.1), value(-1.0, 1.0);
  std::vector<double> t{start}, y{value(random)};
  while (t.back() < start + 1.0) {
    t.push_back(t.back() + gap(random)), y.push_back(value(random));
    if (how.between != TimeSeries::Between::spline && value(random) < -0.5)
      t.push_back(t.back()), y.push_back(value(random));
  }
  return {"data", t, y, how};
}

}  // namespace tandem::test
