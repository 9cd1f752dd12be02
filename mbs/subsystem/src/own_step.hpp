// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "tandem/error.hpp"
#include "tandem/mbs/subsystem.hpp"

namespace tandem::mbs {

/// Throws Error for an own step [s] that is not allowed.
inline void check_step(const std::string& owner, double step) {
  if (!(step > 0.0) || !std::isfinite(step))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{}: step is {} s; allowed is a finite number above 0", owner, step));
}

/// Where index3 knows which steps are cut short.
inline StepperSettings for_own_steps(const SubsystemSettings& settings) {
  StepperSettings stepper = settings.stepper;
  if (stepper.formulation == "index3") stepper.index3.own_step = settings.step;
  return stepper;
}

}  // namespace tandem::mbs
