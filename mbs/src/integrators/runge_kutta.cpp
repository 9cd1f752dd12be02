// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/integrators/runge_kutta.hpp"

namespace tandem::mbs {

RungeKuttaTable midpoint_rule() { return {{0.0, 0.5}, {0.0, 1.0}}; }

RungeKuttaTable classical_runge_kutta() {
  return {{0.0, 0.5, 0.5, 1.0}, {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0}};
}

void RungeKutta::start(SecondOrder& problem, const Motion&) {
  for (Eigen::VectorXd* x : {&x_, &stage_, &rate_, &sum_}) x->resize(2 * problem.size());
}

int RungeKutta::step(SecondOrder& problem, Motion& motion, double h, double t_end) {
  const int n = problem.size();
  x_ << motion.y, motion.v;
  rate_ << motion.v, motion.a;
  AsFirstOrder first_order(problem);
  stages(first_order, motion.time, h);
  x_ += h * sum_;
  motion.time = t_end;
  motion.y = x_.head(n);
  motion.v = x_.tail(n);
  motion.a = rate_.tail(n);
  problem.accelerations(t_end, motion.y.data(), motion.v.data(), motion.a.data());
  return 1;
}

/// sum_ <- sum of b_i k_i, from x_ and the first stage in rate_.
void RungeKutta::stages(FirstOrder& problem, double t, double h) {
  sum_ = table_.b[0] * rate_;
  for (std::size_t i = 1; i < table_.c.size(); ++i) {
    stage_ = x_ + h * table_.c[i] * rate_;
    problem.rates(t + h * table_.c[i], stage_.data(), rate_.data());
    sum_ += table_.b[i] * rate_;
  }
}

}  // namespace tandem::mbs
