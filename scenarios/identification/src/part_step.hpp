// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <optional>

#include "tandem/identification/linear_model.hpp"

namespace tandem::identification {

/// A model's x+ = A x + sum of B_j u(t + places[j] s) + e over a part s of its step.
struct PartStep {
  Eigen::MatrixXd a, b;
  Eigen::VectorXd e;
};

/// Steps of a model that are cut. The model goes by x' = G x + b u + f between its nodes, whose step for constant u is its
/// own: [G b f; 0 0 0] = log([A, sum of B_j, e; 0, 1]) / h. Over a part the solution is exact for polynomials of degree 4.
class PartSteps {
 public:
  explicit PartSteps(const LinearModel& model);

  /// Whether there are such G and b. There are none where A has an eigenvalue that no motion comes to (0, or below 0).
  bool exist() const { return rates_.has_value(); }
  PartStep of(double length) const;

 private:
  Eigen::Index states_, inputs_;
  std::optional<Eigen::MatrixXd> rates_;  ///< [G b f]
};

}  // namespace tandem::identification
