// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/mbs/formulations/formulation.hpp"
#include "tandem/mbs/formulations/terms.hpp"

namespace tandem::mbs {

/// What the penalty and the index-1 formulation share: y are the variables, and the accelerations come from
/// the tangent T = M + alpha Phi_q^T Phi_q and Baumgarte's right-hand side
///   rhs = gamma + 2 xi omega (Phi_q q' + Phi_t) + omega^2 Phi
/// (J. Baumgarte, Comput. Methods Appl. Mech. Eng. 1 (1972) 1). They leave a constraint that steps let drift,
/// by d [1/s] of Phi, off by 2 xi d/omega. Where that is more than a tenth of what Terms::refuse_lost()
/// allows, a step ends with a projection of positions onto that tenth,
///   dq = -T^-1 alpha Phi_q^T (Phi - the tenth).
/// It ends then with the accelerations that belong to these positions.
class Stabilized : public Formulation {
 public:
  int size() const override { return terms_.structure.variables; }
  double length() const override { return terms_.structure.length; }
  void accelerations(double t, const double* y, const double* v, double* a) override;
  void start(State& state) override;
  bool begin(const State& state, Motion& motion) override;
  void finish(const Motion& motion, State& state) override;
  void refresh(State& state) override;
  double penalty() const override { return alpha_; }
  void remember(std::vector<double>& to) const override { terms_.remember(to); }
  void recall(std::span<const double> memory) override { terms_.recall(memory); }

 protected:
  struct Baumgarte {
    double penalty, xi, omega;
    std::string solver;
  };
  /// penalty 0: 1e7 times the largest mass term. Throws Error for a setting that is not allowed.
  Stabilized(const char* owner, Model& model, const Baumgarte& settings);

  /// Accelerations of a state from those at hand, and multipliers if they go with them; T is factorized, and
  /// terms_.error is Phi_q q'' + rhs.
  virtual void solve(State& s) = 0;
  /// Multipliers after that, if they don't.
  virtual void multipliers(State& /*s*/) {}

  Terms terms_;
  double alpha_;

 private:
  void prepare(const State& s);
  void hold();

  Eigen::VectorXd rhs_, with_velocities_;
  double xi_, omega_;
  State at_;  ///< where the last evaluation was
};

}  // namespace tandem::mbs
