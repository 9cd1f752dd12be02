// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

#include "trial.hpp"

namespace tandem::stability {

/// One subsystem as x' = G x + b u, y = C x + D u about the start.
struct LinearSide {
  Eigen::MatrixXd g, b, c, d;
};

/// From its directional derivatives, if it gives them, else from its own steps (undivided.hpp). is_linear:
/// changes may be large. Throws Error(not_supported) for one that follows rates of its inputs, and
/// Error(numerical) for derivatives that its steps contradict.
LinearSide linear_side(const Trial& trial, int instance, bool is_linear);

}  // namespace tandem::stability
