// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

/// The accelerations x = q'' of generalised forces b along what the constraints leave, where a model stands:
///
///     M x + Phi_q^T lambda = b,  Phi_q x = 0,
///
/// x = (M^-1 - M^-1 Phi_q^T (Phi_q M^-1 Phi_q^T)^-1 Phi_q M^-1) b. That needs neither a regular M nor
/// independent equations: solved by (M + alpha Phi_q^T Phi_q) dx = r + alpha Phi_q^T s, dlambda = alpha (Phi_q dx - s) from
/// the residuals r and s of both equations, until dx falls no more. Coordinates are scaled to masses of 1, gradients to a
/// length of 1.
class ConstrainedAccelerations {
 public:
  /// `model` must outlive it.
  explicit ConstrainedAccelerations(const Model& model);
  ~ConstrainedAccelerations();

  /// At positions q, all coordinates of them. Factorizes; allocates.
  void stand_at(const Eigen::VectorXd& q);
  /// Of the variables. Throws Error(numerical) if they can't be told.
  Eigen::VectorXd of(const Eigen::VectorXd& b) const;

 private:
  class Solver;
  const Model& model_;
  std::unique_ptr<Solver> solver_;
  std::vector<double> jacobian_;
  Eigen::VectorXd phi_;
};

}  // namespace tandem::mbs
