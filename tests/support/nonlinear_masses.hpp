// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

#include "tandem/fixed_step.hpp"

namespace tandem::test {

/// A mass at a wall spring k, and at a coupling spring that hardens:
///   m x'' = -k x - f(x - u),  f(e) = k1 e + k3 e^3,  u the displacement of the mass at its other end.
/// Energy: m v^2 / 2 + k x^2 / 2 for each mass, and k1 e^2 / 2 + k3 e^4 / 4 for the coupling.
/// An own step is many small ones of the classical Runge-Kutta method, so that the coupling is practically
/// the only error: its amplitude factor is 1 - (w h)^6 / 144 a small step. For FixedStep<Model>.
class NonlinearMass {
 public:
  struct Parameters {
    double m, k, x0, v0, own_step;
  };
  static constexpr double k1 = 5.0, k3 = 4.0;  ///< coupling spring [N/m], [N/m^3]
  static constexpr double small_step = 2e-3;   ///< at most [s]

  explicit NonlinearMass(const Parameters& p) : p_(p) {}

  SubsystemInfo info() const {
    return {"nonlinear_mass", {{"u", "m"}}, {{"x", "m", 1, 1}, {"v", "m/s"}}, {}, {}};
  }
  double own_step() const { return p_.own_step; }
  void start(double, std::span<const double>) { x_ = p_.x0, v_ = p_.v0; }
  void step(const OwnStep& s, std::span<const Signal> u) {
    const int count = static_cast<int>(std::ceil(s.length / small_step));
    const double h = s.length / count;
    for (int i = 0; i < count; ++i) small(s.begin + i * h, h, u[0]);
  }
  void outputs(double* y) const { y[0] = x_, y[1] = v_, y[2] = v_, y[3] = 0.0; }

  static double energy(const Parameters& a, double xa, double va, const Parameters& b, double xb, double vb) {
    const double e = xa - xb;
    return 0.5 * (a.m * va * va + a.k * xa * xa + b.m * vb * vb + b.k * xb * xb + k1 * e * e +
                  0.5 * k3 * e * e * e * e);
  }

 private:
  double acceleration(double x, double u) const {
    return -(p_.k * x + k1 * (x - u) + k3 * std::pow(x - u, 3)) / p_.m;
  }
  void small(double t, double h, const Signal& u) {
    const double begin = u.value(t), middle = u.value(t + 0.5 * h), end = u.value(t + h);
    const double a1 = acceleration(x_, begin), v2 = v_ + 0.5 * h * a1;
    const double a2 = acceleration(x_ + 0.5 * h * v_, middle), v3 = v_ + 0.5 * h * a2;
    const double a3 = acceleration(x_ + 0.5 * h * v2, middle), v4 = v_ + h * a3;
    const double a4 = acceleration(x_ + h * v3, end);
    x_ += h / 6.0 * (v_ + 2.0 * v2 + 2.0 * v3 + v4);
    v_ += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  }

  Parameters p_;
  double x_ = 0.0, v_ = 0.0;
};

}  // namespace tandem::test
