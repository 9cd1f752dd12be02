// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::four_bar {

/// A run of the linkage from the start.
struct Case {
  int loops;
  mbs::StepperSettings stepper;
  double step;           ///< [s]
  std::string settings;  ///< in words, where the stepper is not as in the other cases
};

/// Where a linkage stands.
struct Place {
  double time;   ///< [s]
  double tilt;   ///< the largest difference in height of a coupler's ends [m]: 0 in a parallelogram
  double angle;  ///< of the first crank from upright, -pi to pi [rad]
};

/// The parallelogram counts as lost when a coupler of 1 m stands 6 degrees off.
inline constexpr double lost_tilt = 0.1;  // [m]

/// What a run came to. Where it ended early, the figures are those of its last state.
struct Result {
  double time = 0.0;                              ///< of the last state [s]
  double iterations = 0.0;                        ///< of a step, on average
  double x_error = 0.0;                           ///< of the first moving point's x [m]
  double energy_drift = 0.0, largest_tilt = 0.0;  ///< as a part of the potential energy at the start; [m]
  double position_residual = 0.0, velocity_residual = 0.0, acceleration_residual = 0.0;
  std::string status;  ///< "ok", "lost at 1.26 s", "failed at 0.72 s"
  std::string note;    ///< Why it failed, without commas.
};

/// Runs until `end` [s], the loss of the parallelogram, or what the stepper can't do. `seen` is told of each
/// state, if given.
Result run(const Case& c, double end, const std::function<void(const Place&)>& seen = {});

}  // namespace tandem::four_bar
