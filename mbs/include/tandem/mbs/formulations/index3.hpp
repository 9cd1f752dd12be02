// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/mbs/model.hpp"
#include "tandem/mbs/sparse/tangent.hpp"

namespace tandem::mbs {

struct Index3Settings {
  double penalty = 0.0;            ///< alpha; 0: 1e7 times the largest mass term
  double beta = 0.25;              ///< Newmark's, 1/12 to 1/4; gamma is 1/2. 1/4: the trapezoidal rule
  double tolerance = 1e-10;        ///< [m] Newton's iteration ends when |dq| (Euclidean) is below
  int most_iterations = 30;        ///< then it has failed
  int multiplier_iterations = 10;  ///< of these update the multipliers; the others keep them
  int projections = 1;             ///< of velocities and of accelerations; each divides their error anew
  bool carry_multipliers = false;  ///< a step begins with the multipliers of the one before, not with zero
  std::string solver = "klu";
};

/// Index-3 augmented Lagrangian formulation with Newmark's method merged in, and mass-orthogonal projections
/// of velocities and accelerations (E. Bayo, R. Ledesma, Nonlinear Dynamics 9 (1996) 113; J. Cuadrado et al.,
/// Multibody System Dynamics 4 (2000) 55). A step solves, in the positions of its end,
///   f = beta h^2 [M q'' + Phi_q^T (lambda + alpha Phi) - Q] = 0
/// by Newton's method with the tangent T = M + h/2 C + beta h^2 (K + alpha Phi_q^T Phi_q), from the positions
/// that constant acceleration leads to. After each correction lambda <- lambda + alpha Phi. Then, with the
/// last T,
///   T dv = -beta h^2 alpha Phi_q^T (Phi_q q' + Phi_t),  T da = -beta h^2 alpha Phi_q^T (Phi_q q'' + gamma).
/// (The literature writes T q' = (T - beta h^2 alpha Phi_q^T Phi_q) q'* - beta h^2 alpha Phi_q^T Phi_t, which
/// is the same.)
class Index3 {
 public:
  /// `model` must outlive it. Throws Error for a setting that is not allowed.
  Index3(Model& model, const Index3Settings& settings);

  /// Completes a state of which time, q and v satisfy the constraints: accelerations and multipliers.
  void start(State& state);
  /// One step of length h [s]. Returns the number of iterations. Throws Error(numerical) with the time for no
  /// convergence and for a singular tangent, with its variable; the state is then of no use.
  int step(State& state, double h);

  /// The multipliers that belong to the accelerations of the state after the last step(), of order 2:
  /// lambda + beta h^2 alpha (Phi_q q'' + gamma), summed over the projections. (state.lambda
  /// belongs to the accelerations before the projection, which are of order 1.)
  Eigen::VectorXd multipliers(const State& state) const;

 private:
  void evaluate(const State& s);
  void prepare(const State& s, const TangentFactors& factors);
  double correct(State& s, double h);
  void project_velocities(State& s);
  void project_accelerations(State& s);
  void solve_constraint_error();

  Model& model_;
  const Structure& structure_;
  Index3Settings settings_;
  double penalty_, scale_ = 0.0;  ///< beta h^2 of the last step
  Tangent tangent_;
  ModelMatrices matrices_;
  Eigen::VectorXd phi_, error_, shift_, force_, residual_;
};

}  // namespace tandem::mbs
