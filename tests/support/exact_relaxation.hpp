// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "exact_pieces.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem::test {

/// Two first-order subsystems that need each other's output in their first derivative: the coupling in which
/// a repeated start gains least from a pass.
///   A: a' = -(damping + k) a + u,  u from B;  gives a
///   B: b' = -damping b - w^2 u,    u from A;  gives b + k u, which follows u at once if k is not 0
/// Together a' = -damping a + b, b' = -damping b - w^2 a, for any k: a = e^(-damping t) cos w t, b = -w
/// e^(-damping t) sin w t.
struct Relaxation {
  double damping = 0.1, w = 2.0;  ///< [1/s]
  double k = 0.0;                 ///< [1/s] feedthrough of B

  std::array<double, 2> exact(double t) const {
    const double e = std::exp(-damping * t);
    return {e * std::cos(w * t), -w * e * std::sin(w * t)};
  }
};

/// One side of Relaxation, x' = -rate x + f u, propagated exactly under its piecewise polynomial input. For
/// FixedStep<Model>.
class ExactRelaxation {
 public:
  struct Options {
    bool first = true;  ///< A, else B
    double h = 0.1;     ///< [s]
    double exact_until =
        -std::numeric_limits<double>::infinity();  ///< [s] up to there it gives the exact motion
  };
  ExactRelaxation(const Relaxation& system, Options options)
      : system_(system),
        options_(options),
        rate_(options.first ? system.damping + system.k : system.damping),
        f_(options.first ? 1.0 : -system.w * system.w),
        k_(options.first ? 0.0 : system.k) {}

  SubsystemInfo info() const {
    SubsystemInfo info{"exact_relaxation", {{"u", "1"}}, {{"y", "1"}}, {}, {}};
    if (k_ != 0.0) info.feedthrough.push_back({0, 0});
    return info;
  }
  double own_step() const { return options_.h; }
  void start(double t, std::span<const double> u0) {
    set_exact(t);
    input_ = u0[0];
  }
  void step(const OwnStep& s, std::span<const Signal> u) {
    if (s.end <= options_.exact_until) return set_exact(s.end);
    for_each_piece(u[0], s,
                   [&](const Segment& piece, double from, double to) { propagate(piece, from, to); });
    input_ = u[0].value(s.end);
  }
  void outputs(double* y) const { y[0] = k_ == 0.0 ? x_ : x_ + k_ * input_; }

 private:
  /// The power series of the solution about `from`, (n + 1) x_{n+1} = f u_n - rate x_n, as Oscillator.
  void propagate(const Segment& piece, double from, double to) {
    constexpr int terms = 26;
    const auto u = shifted(piece, from);
    double c[terms] = {x_};
    for (int n = 0; n + 1 < terms; ++n)
      c[n + 1] = (f_ * (n < TANDEM_MAX_COEFFICIENTS ? u[static_cast<std::size_t>(n)] : 0.0) - rate_ * c[n]) /
                 (n + 1);
    x_ = 0.0;
    for (int n = terms - 1; n >= 0; --n) x_ = x_ * (to - from) + c[n];
  }
  void set_exact(double t) {
    const auto [a, b] = system_.exact(t);
    x_ = options_.first ? a : b;
    input_ = options_.first ? b + system_.k * a : a;
  }

  Relaxation system_;
  Options options_;
  double rate_, f_, k_;
  double x_ = 0.0, input_ = 0.0;
};

}  // namespace tandem::test
