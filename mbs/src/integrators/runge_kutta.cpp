// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/integrators/runge_kutta.hpp"

#include "tandem/mbs/sparse/products.hpp"

namespace tandem::mbs {

RungeKuttaTable midpoint_rule() { return {{0.0, 0.5}, {{}, {0.5}}, {0.0, 1.0}}; }

RungeKuttaTable classical_runge_kutta() {
  return {{0.0, 0.5, 0.5, 1.0},
          {{}, {0.5}, {0.0, 0.5}, {0.0, 0.0, 1.0}},
          {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0}};
}

void RungeKutta::start(SecondOrder& problem, const Motion&) {
  const int n = 2 * problem.size();
  x_.resize(n), stage_.resize(n);
  rates_.resize(n, static_cast<int>(table_.c.size()));
}

int RungeKutta::step(SecondOrder& problem, Motion& motion, double h, double t_end) {
  const int n = problem.size();
  x_ << motion.y, motion.v;
  rates_.col(0) << motion.v, motion.a;
  AsFirstOrder first_order(problem);
  stages(first_order, motion.time, h);
  add(table_.b, h, rates_, x_);
  motion.time = t_end;
  motion.y = x_.head(n);
  motion.v = x_.tail(n);
  motion.a = rates_.col(rates_.cols() - 1).tail(n);
  problem.accelerations(t_end, motion.y.data(), motion.v.data(), motion.a.data());
  return 1;
}

/// From x_ and the first stage in rates_. The guess of each stage's rates is those of the one before.
void RungeKutta::stages(FirstOrder& problem, double t, double h) {
  for (int i = 1; i < rates_.cols(); ++i) {
    stage_ = x_;
    add(table_.a[i], h, rates_, stage_);
    rates_.col(i) = rates_.col(i - 1);
    problem.rates(t + h * table_.c[i], stage_.data(), rates_.col(i).data());
  }
}

/// x += h sum of weights times rates.
void RungeKutta::add(const std::vector<double>& weights, double h, const Eigen::MatrixXd& rates,
                     Eigen::VectorXd& x) {
  const double* rate = rates.data();
  for (const double weight : weights) {
    if (weight != 0.0) add_scaled(x.size(), x.data(), h * weight, rate, x.data());
    rate += x.size();
  }
}

}  // namespace tandem::mbs
