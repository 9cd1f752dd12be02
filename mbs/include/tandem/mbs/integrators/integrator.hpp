// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

namespace tandem::mbs {

/// A problem y'' = f(t, y, y').
class SecondOrder {
 public:
  virtual ~SecondOrder() = default;
  virtual int size() const = 0;
  virtual double length() const { return 1.0; }  ///< default tolerances are in proportion to it [m]
  /// a becomes f(t, y, v); on entry it is a guess of that, such as f at a time nearby. Arrays of size().
  virtual void accelerations(double t, const double* y, const double* v, double* a) = 0;
};

/// Where a second-order problem stands.
struct Motion {
  double time = 0.0;        ///< [s]
  Eigen::VectorXd y, v, a;  ///< y, y' and y'' = f(t, y, y')
};

/// A method for second-order problems.
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Forgets the steps before: at the start, and where a problem changes its coordinates.
  virtual void start(SecondOrder& problem, const Motion& motion) = 0;
  /// One step of length h > 0 [s] that ends at t_end. The problem's last evaluation is at the motion that it
  /// leaves. Returns the number of iterations (1 for an explicit method). Throws Error(numerical) with the
  /// time for no convergence; it never takes a smaller step instead.
  virtual int step(SecondOrder& problem, Motion& motion, double h, double t_end) = 0;
  /// See Stepper::remember().
  virtual void remember(std::vector<double>& /*to*/) const {}
  virtual void recall(std::span<const double> /*memory*/) {}
};

}  // namespace tandem::mbs
