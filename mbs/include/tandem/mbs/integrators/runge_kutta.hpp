// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/mbs/integrators/first_order.hpp"

namespace tandem::mbs {

/// Explicit Runge-Kutta methods in which a stage depends on the one before alone: stage i stands at
/// t + c_i h, at x + c_i h k_(i-1), and x + h sum b_i k_i is the end (E. Hairer, S. Norsett, G. Wanner,
/// Solving Ordinary Differential Equations I, sect. II.1).
struct RungeKuttaTable {
  std::vector<double> c, b;
};
RungeKuttaTable midpoint_rule();          ///< order 2
RungeKuttaTable classical_runge_kutta();  ///< order 4

/// Such a method for second-order problems, through AsFirstOrder. A step takes as many evaluations as the
/// method has stages, as the one at its end is the first stage of the next step.
class RungeKutta final : public Integrator {
 public:
  explicit RungeKutta(RungeKuttaTable table) : table_(std::move(table)) {}
  void start(SecondOrder& problem, const Motion& motion) override;
  int step(SecondOrder& problem, Motion& motion, double h, double t_end) override;

 private:
  void stages(FirstOrder& problem, double t, double h);

  RungeKuttaTable table_;
  Eigen::VectorXd x_, stage_, rate_, sum_;
};

}  // namespace tandem::mbs
