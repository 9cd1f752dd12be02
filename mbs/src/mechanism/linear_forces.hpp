// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

/// Forces and constraints of a model where it stands, as dense matrices.
class DenseTerms {
 public:
  /// `model` must outlive it and stands at its time.
  explicit DenseTerms(const Model& model);

  /// Q, Phi and Phi_q^T there.
  void evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& v);
  /// Q - Phi_q^T lambda after evaluate().
  Eigen::VectorXd unbalanced(const Eigen::VectorXd& lambda) const { return force - gradients * lambda; }

  /// -d(Q - Phi_q^T lambda)/dq and -dQ/dq' by central differences.
  Eigen::MatrixXd stiffness(const State& at);
  Eigen::MatrixXd damping(const State& at);
  Eigen::MatrixXd mass() const;

  Eigen::VectorXd force, phi;
  Eigen::MatrixXd gradients;  ///< n x m

 private:
  const Model& model_;
  std::vector<double> values_;
};

/// What the constraints leave: orthonormal columns R with Phi_q R = 0, from gradients Phi_q^T.
Eigen::MatrixXd free_motions(const Eigen::MatrixXd& gradients);

}  // namespace tandem::mbs
