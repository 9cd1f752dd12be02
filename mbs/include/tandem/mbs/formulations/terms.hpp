// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/mbs/model.hpp"
#include "tandem/mbs/sparse/products.hpp"
#include "tandem/mbs/sparse/tangent.hpp"

namespace tandem::mbs {

/// A model's terms where a state stands, with a factorized tangent T = M + .. + penalty Phi_q^T Phi_q: what
/// the formulations with a penalty share. Nothing here allocates after construction.
struct Terms {
  /// `model` must outlive it. kind: of T. Throws Error for a solver that is not there.
  Terms(Model& model, const std::string& solver, MatrixKind kind);

  /// Phi and Phi_q^T.
  void constraints(const State& s);
  /// At the end of a step, after constraints(). Error(numerical) names the constraint and the time where
  /// Phi_q^T has a column that vanishes (below 1e-12 of the largest). It does so too where a constraint is
  /// lost: |Phi| above a hundredth of its size.
  void refuse_lost(const State& s) const;
  /// error <- what is left of Phi beyond a tenth of that; whether there is anything.
  bool nearly_lost();
  /// Q.
  void forces(const State& s);
  /// Assembles T at a state, after constraints(). Error(numerical) names variable, constraints and time of a
  /// T that is singular, or not positive definite if the solver needs that. `auto` then takes a solver for
  /// symmetric matrices, in this factorization only.
  void factorize(const State& s, const TangentFactors& factors);
  /// x <- T^-1 x.
  void solve(Eigen::VectorXd& x);
  /// What factorizations go by besides the state, and back: T is that of the time then, which was definite if
  /// it is of use.
  void remember(std::vector<double>& to) const;
  void recall(std::span<const double> memory);
  /// correction <- factor T^-1 [Q - M a - Phi_q^T weights]; returns its Euclidean norm. Error(numerical)
  /// names a variable and the time where that is not finite.
  double correct(const State& s, const Eigen::VectorXd& weights, double factor);

  /// error <- Phi_q x + rhs.
  void violation(const Eigen::VectorXd& x, const Eigen::VectorXd& rhs);
  /// error <- Phi_q (x + correction) + rhs, from Phi_q x + rhs.
  void follow_correction();
  /// x <- x - T^-1 Phi_q^T weight error.
  void project(Eigen::VectorXd& x, double weight);

  /// Augmented Lagrangian of index 1 from the a, lambda and error e = Phi_q a + rhs at hand. Precondition:
  /// forces() and factorize() came before. It repeats
  ///   a <- a + T^-1 [Q - M a - Phi_q^T (lambda + penalty e)], then lambda <- lambda + penalty e
  /// until the next |da|, at the rate of the last two, is <= tolerance (|a| + |Q| / largest mass term). The
  /// residual, not the right-hand side, is multiplied by T^-1, as in the second penalty |rhs| is lost to
  /// rounding. Returns the iterations, 0 if these were not enough.
  /// - penalty: the penalty in T; other terms in T change the way but not the end.
  int settle(State& s, double penalty, double tolerance, int most);

  /// T, not factorized.
  void assemble(const State& s, const TangentFactors& factors);
  /// correction <- factor [Q - M a - Phi_q^T weights].
  void residual(const State& s, const Eigen::VectorXd& weights, double factor);

  Model& model;
  const Structure& structure;
  Tangent tangent;
  bool definite = true;  ///< the last T: what `tangent` holds is of no use otherwise
  Rows jacobian_rows;
  ModelMatrices matrices;
  Eigen::VectorXd phi, gamma, error, weights;  ///< m
  Eigen::VectorXd force, inertia, correction;  ///< n; the second: M a
  double largest_mass;                         ///< the largest entry of M; 1 if there is none [kg]

 private:
  void make_indefinite();
  int factorize_indefinite(const TangentFactors& factors);

  std::vector<double> most_off_;  ///< by constraint
  std::string solver_;
  MatrixKind kind_;
  std::unique_ptr<Tangent> indefinite_;  ///< made when it is needed first
};

}  // namespace tandem::mbs
