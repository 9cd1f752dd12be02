// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/mbs/integrators/first_order.hpp"

namespace tandem::mbs {

/// Explicit Runge-Kutta methods: stage i stands at t + c_i h, at x + h sum a_ij k_j over the stages j before
/// it, and x + h sum b_i k_i is the end (E. Hairer, S. Norsett, G. Wanner, Solving Ordinary Differential
/// Equations I, sect. II.1).
struct RungeKuttaTable {
  std::vector<double> c;
  std::vector<std::vector<double>> a;  ///< row i: i numbers
  std::vector<double> b;
};
RungeKuttaTable midpoint_rule();          ///< order 2
RungeKuttaTable classical_runge_kutta();  ///< order 4
/// Order 8 in 12 stages: the method of J. Dormand and P. Prince behind DOP853, without its error estimates
/// (the same book, sect. II.5 and appendix).
RungeKuttaTable dormand_prince8();

/// Such a method for second-order problems, through AsFirstOrder. A step takes as many evaluations as the
/// method has stages, as the one at its end is the first stage of the next step.
class RungeKutta final : public Integrator {
 public:
  explicit RungeKutta(RungeKuttaTable table) : table_(std::move(table)) {}
  void start(SecondOrder& problem, const Motion& motion) override;
  int step(SecondOrder& problem, Motion& motion, double h, double t_end) override;

 private:
  void stages(FirstOrder& problem, double t, double h);
  static void add(const std::vector<double>& weights, double h, const Eigen::MatrixXd& rates,
                  Eigen::VectorXd& x);

  RungeKuttaTable table_;
  Eigen::VectorXd x_, stage_;
  Eigen::MatrixXd rates_;  ///< by column those of a stage
};

}  // namespace tandem::mbs
