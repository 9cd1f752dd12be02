// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

/// What the constraints leave free where a model stands.
struct Freedom {
  int rank = 0;                ///< of Phi_q
  int degrees = 0;             ///< of freedom: variables less the rank
  std::vector<int> redundant;  ///< constraints whose gradients depend on those of the others
};

/// By a QR decomposition of Phi_q^T that puts dependent columns last, where a Cholesky decomposition of
/// Phi_q Phi_q^T leaves it open. At a singular position the rank is that of the position alone.
Freedom freedom(Model& model, const State& state);

}  // namespace tandem::mbs
