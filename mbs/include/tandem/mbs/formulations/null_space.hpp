// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/QR>
#include <vector>

#include "tandem/mbs/formulations/formulation.hpp"

namespace tandem::mbs {

struct NullSpaceSettings {
  /// Newton's iteration for dependent variables ends when |dq| is below [m]; 0: 1e-12 of the model's length
  double tolerance = 0.0;
  int most_iterations = 30;  ///< then it has failed

  bool operator==(const NullSpaceSettings&) const = default;
};

/// Coordinate partitioning (R. Wehage, E. Haug, J. Mech. Des. 104 (1982) 247): y are independent variables
/// z; dependent ones follow from Phi = 0 by Newton's method, their rates from Phi_q q' + Phi_t = 0. With
/// q'' = R z'' + c, where the columns of R span the null space of Phi_q and Phi_q c = -gamma,
///   R^T M R z'' = R^T (Q - M c),  and Phi_q^T lambda = Q - M q'', of the least norm where it is not unique.
/// A QR decomposition of Phi_q with pivoting chooses. Rows that depend on others do no harm. The choice stays
/// for as long as its last pivot is above half of the last pivot of a new one. No penalty, no Newmark, dense
/// matrices: an independent check of the other formulations, for small models. It allocates.
class NullSpace final : public Formulation {
 public:
  /// `model` must outlive it. Throws Error for a setting that is not allowed.
  NullSpace(Model& model, const NullSpaceSettings& settings);

  int size() const override { return static_cast<int>(independent_.size()); }
  double length() const override { return structure_.length; }
  void accelerations(double t, const double* y, const double* v, double* a) override;
  /// Error(numerical) also for a rank of Phi_q that is not that of the start.
  bool begin(const State& state, Motion& motion) override;
  void finish(const Motion& motion, State& state) override;
  void start(State& state) override;
  void refresh(State& state) override;
  void remember(std::vector<double>& to) const override {
    to.insert(to.end(), dependent_.begin(), dependent_.end());
  }
  void recall(std::span<const double> memory) override;

 private:
  void constraints();
  bool choose();
  void solve_positions();
  void solve_velocities();
  void solve_accelerations();
  void solve_multipliers();

  Model& model_;
  const Structure& structure_;
  NullSpaceSettings settings_;
  double tolerance_;
  State at_;  ///< where the last evaluation was
  bool chosen_ = false;
  std::vector<int> dependent_, independent_;
  std::vector<double> jacobian_values_;
  Eigen::MatrixXd mass_, jacobian_;
  std::vector<double> most_off_;
  Eigen::VectorXd phi_, force_;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> held_;  ///< of the columns of Phi_q of the dependent variables
};

}  // namespace tandem::mbs
