// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::mbs {

/// By how much inputs accelerate coordinates, of the outputs that ask for it. With b the generalised forces of an input of
/// 1 the accelerations x = q'' of it alone follow from
///
///     M x + Phi_q^T lambda = b,  Phi_q x = 0,
///
/// x = (M^-1 - M^-1 Phi_q^T (Phi_q M^-1 Phi_q^T)^-1 Phi_q M^-1) b, which needs neither a regular M nor independent
/// equations. Solved by (M + alpha Phi_q^T Phi_q) dx = r + alpha Phi_q^T s, dlambda = alpha (Phi_q dx - s) from the
/// residuals r and s of both equations, until dx falls no more.
class Accelerances {
 public:
  /// `mechanism` must outlive it.
  Accelerances(const Mechanism& mechanism, const std::vector<Output>& outputs);
  ~Accelerances();

  /// Where a state stands: the values, or their rates by a central difference along the motion. Throws Error(numerical) if
  /// they can't be told. One factorization each, of the rates two; they allocate.
  void find(const State& s);
  void find_rates(const State& s);
  /// Of an output of that kind, by its number.
  double value(int output) const { return values_[places_[static_cast<std::size_t>(output)]]; }
  double rate(int output) const { return rates_[places_[static_cast<std::size_t>(output)]]; }

 private:
  class Solver;
  struct One {
    int coordinate, input;
  };
  void find(const Eigen::VectorXd& q, std::vector<double>& to);
  Eigen::VectorXd push(int input, const Eigen::VectorXd& q) const;

  const Mechanism& mechanism_;
  std::unique_ptr<Solver> solver_;
  std::vector<One> all_;
  std::vector<std::size_t> places_;  ///< by output; of that kind
  std::vector<double> values_, rates_, after_, jacobian_;
};

}  // namespace tandem::mbs
