// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Dense>
#include <string>
#include <vector>

#include "trial.hpp"

namespace tandem::stability {

/// The modes of the coupled system as one that nothing divides, by columns.
struct TrueModes {
  Eigen::VectorXcd rates;    ///< mu [1/s]: a mode is multiplied by exp(mu T) over a super-step
  Eigen::MatrixXcd vectors;  ///< by state; those of sampled subsystems after the instants there
  Eigen::MatrixXd parts;     ///< how much each state takes part, without a unit (undivided.hpp)
  std::vector<std::string> states;
  int at_rest = 0;  ///< modes that turn and grow by no more than `rest` over a super-step
  static constexpr double rest = 1e-6;
};

/// Of a system in which something is sampled they are those of its map over a super-step (sampled_map.hpp), without
/// what is forgotten in it (remembered.hpp).
/// Throws Error(not_supported) as undivided() and SampledMap do.
TrueModes true_modes(const Trial& trial, bool is_linear);

}  // namespace tandem::stability
