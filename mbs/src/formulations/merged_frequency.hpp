// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/formulations/terms.hpp"

namespace tandem::mbs {

/// The highest frequency of the motion that the constraints leave: its square is the spectral radius of
/// T^-1 (K + d(Phi_q^T lambda)/dq), where T = M + penalty Phi_q^T Phi_q takes constrained directions away.
/// The penalty's own frequencies, sqrt(penalty) times the singular values of Phi_q, are not among them: the
/// merged formulation satisfies Phi = 0, whatever the penalty.
class MergedFrequency {
 public:
  /// `terms` must outlive it.
  explicit MergedFrequency(Terms& terms);

  /// At a complete state [rad/s]. Factorizes T once.
  double at(const State& s, double penalty);

 private:
  void multiply_stiffness(const State& s, Eigen::VectorXd& z);
  void add_constraint_forces(double factor, Eigen::VectorXd& to);

  Terms& terms_;
  Rows stiffness_rows_;
  State moved_;
  Eigen::VectorXd argument_, product_, force_;
};

}  // namespace tandem::mbs
