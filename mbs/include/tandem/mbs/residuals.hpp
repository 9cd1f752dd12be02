// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

/// By how much a state misses the constraints: the largest absolute value, in the units of the constraints.
struct Residuals {
  double position = 0.0;      ///< of Phi
  double velocity = 0.0;      ///< of Phi_q q' + Phi_t
  double acceleration = 0.0;  ///< of Phi_q q'' + gamma
};

/// Evaluates them again and again, without allocation.
class ConstraintResiduals {
 public:
  explicit ConstraintResiduals(const Structure& structure);
  /// The model has that structure and stands at the state's time.
  Residuals operator()(const Model& model, const State& state);

 private:
  double largest(const Structure& structure, const Eigen::VectorXd& x);

  Eigen::VectorXd phi_, extra_, jacobian_;
};

/// Puts the model at the state's time.
Residuals residuals(Model& model, const State& state);

}  // namespace tandem::mbs
