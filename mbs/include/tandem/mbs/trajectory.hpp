// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

#include "tandem/mbs/make_stepper.hpp"

namespace tandem::mbs {

/// A motion in equal steps: of row k the time is k h.
struct Trajectory {
  Eigen::VectorXd time;  ///< [s]
  Eigen::MatrixXd q, v;  ///< a row for each time, a column for each coordinate
  long iterations = 0;   ///< of Newton's method, of all steps
};

/// Steps a model from `start`, where q and v satisfy the constraints, `steps` times by h [s]. Throws Error
/// for settings that are not allowed, and what the stepper throws.
Trajectory trajectory(Model& model, State start, const StepperSettings& settings, double h, int steps);

}  // namespace tandem::mbs
