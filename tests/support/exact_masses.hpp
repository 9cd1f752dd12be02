// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

#include "exact_pieces.hpp"
#include "tandem/fixed_step.hpp"
#include "two_mass/model.hpp"

namespace tandem::test {

/// x'' + w^2 x = f u under one polynomial piece u, solved by the power series of its solution about `from`,
///   (n + 1)(n + 2) x_{n+2} = f u_n - w^2 x_n:
/// exact to rounding, and free of the cancellation of "polynomial plus sine and cosine", whose polynomial
/// grows as 1/w^k. The terms fall as (w h)^n / n!; 26 of them leave less than 1e-16 for w h up to 3.
struct Oscillator {
  double square;  ///< w^2 [1/s^2]
  double f;       ///< input's gain over the mass

  /// Moves displacement x and velocity v from time `from` to time `to`.
  void propagate(const Segment& piece, double from, double to, double& x, double& v) const {
    constexpr int terms = 26;
    const auto u = shifted(piece, from);
    double c[terms] = {x, v};
    for (int n = 0; n + 2 < terms; ++n)
      c[n + 2] = (f * (n < TANDEM_MAX_COEFFICIENTS ? u[static_cast<std::size_t>(n)] : 0.0) - square * c[n]) /
                 ((n + 1) * (n + 2));
    x = v = 0.0;
    for (int n = terms - 1; n >= 0; --n) x = x * (to - from) + c[n];
    for (int n = terms - 1; n >= 1; --n) v = v * (to - from) + n * c[n];
  }
};

/// One side of the two-mass test, m x'' = g u - K x, propagated exactly under its piecewise polynomial input,
/// piece by piece where a break lies inside the own step. So the coupling is the only error of a run. For
/// FixedStep<Model>. Ports as two_mass.fast and two_mass.slow, with as many derivatives as asked for. In a
/// force coupling either side may be the one that gives F = k2 (own - partner's displacement), which follows
/// its input at once.
class ExactMass {
 public:
  enum class Coupling { displacement, gives_force, reads_force };
  struct Options {
    bool fast = true;
    Coupling coupling = Coupling::displacement;
    int derivatives = 2;       ///< of the displacement, 0 to 3; of the velocity one fewer; of F none
    int true_derivatives = 3;  ///< those beyond are given as 0
    double exact_until =
        -std::numeric_limits<double>::infinity();  ///< [s] up to there it gives the exact motion
    double own_step = 0.0;                         ///< [s]; 0: the side's in the two-mass test
  };
  ExactMass(const two_mass::Model& model, Options options)
      : model_(model),
        options_(options),
        mass_(options.fast ? model.m1 : model.m2),
        gain_(reads_force() ? 1.0 : model.k2),
        stiffness_((options.fast ? model.k1 : model.k3) + (reads_force() ? 0.0 : model.k2)) {}

  SubsystemInfo info() const {
    const int less = std::max(0, options_.derivatives - 1);
    SubsystemInfo info{"exact_mass", {{options_.fast ? "x2" : "x1", "m"}}, {}, {}, {}};
    info.outputs = {{options_.fast ? "x1" : "x2", "m", 1, options_.derivatives},
                    {options_.fast ? "v1" : "v2", "m/s", 1, less}};
    if (reads_force()) info.inputs[0] = {"F", "N"};
    if (!gives_force()) return info;
    info.outputs.push_back({"F", "N"});
    info.feedthrough.push_back({2, 0});
    return info;
  }
  double own_step() const {
    return options_.own_step > 0.0 ? options_.own_step : options_.fast ? model_.h1 : model_.h2;
  }

  void start(double t, std::span<const double> u0) {
    set_exact(t);
    input_ = u0[0];
  }

  void step(const OwnStep& s, std::span<const Signal> u) {
    if (s.end <= options_.exact_until) return set_exact(s.end);
    input_ = u[0].value(s.end);
    input_rate_ = u[0].derivative(s.end);
    const Oscillator oscillator{stiffness_ / mass_, gain_ / mass_};
    for_each_piece(u[0], s, [&](const Segment& piece, double from, double to) {
      oscillator.propagate(piece, from, to, x_, v_);
    });
  }

  /// Blocks of (displacement, velocity[, force]), their derivatives, and so on.
  void outputs(double* y) const {
    const double a = (gain_ * input_ - stiffness_ * x_) / mass_;
    const double jerk = (gain_ * input_rate_ - stiffness_ * v_) / mass_;
    const double x[] = {x_, v_, a, jerk, 0.0};
    for (int k = 0; k <= options_.derivatives; ++k) {
      const bool known = k <= options_.true_derivatives;
      *y++ = known ? x[k] : 0.0;
      *y++ = k == 0 || (known && k < options_.derivatives) ? x[k + 1] : 0.0;
      if (gives_force()) *y++ = k == 0 ? model_.k2 * (x_ - input_) : 0.0;
    }
  }

 private:
  bool gives_force() const { return options_.coupling == Coupling::gives_force; }
  bool reads_force() const { return options_.coupling == Coupling::reads_force; }

  void set_exact(double t) {
    const two_mass::Motion m = model_.exact(t);
    x_ = options_.fast ? m.x1 : m.x2;
    v_ = options_.fast ? m.v1 : m.v2;
    const double partner = options_.fast ? m.x2 : m.x1, partner_rate = options_.fast ? m.v2 : m.v1;
    input_ = reads_force() ? model_.k2 * (partner - x_) : partner;
    input_rate_ = reads_force() ? model_.k2 * (partner_rate - v_) : partner_rate;
  }

  two_mass::Model model_;
  Options options_;
  double mass_, gain_, stiffness_;
  double x_ = 0.0, v_ = 0.0;               ///< state
  double input_ = 0.0, input_rate_ = 0.0;  ///< at the end of the last step
};

}  // namespace tandem::test
