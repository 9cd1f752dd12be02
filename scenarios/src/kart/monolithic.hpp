// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <vector>

#include "kart/kart_model.hpp"
#include "kart/power_train.hpp"

namespace tandem::kart {

/// The whole manoeuvre of a kart of level i or ii as one system: kart and power train by the classical
/// Runge-Kutta method with one step.
struct Monolithic {
  struct Row {
    double time, torque, speed, shaft_speed, pitch, engine_speed;  ///< [s, N m, m/s, rad/s, rad, rad/s]
    int gear;
  };
  std::vector<Row> rows;  ///< at each step's beginning, and at the end
  std::vector<PowerTrain::Shift> shifts;
};

/// `kart` has outputs shaft_speed, pitch, speed first, and no wheel that hinges on its torque but by them.
/// throttle_scale: the plate's angle above that of the start is multiplied by it.
Monolithic run_monolithic(KartModel& kart, double step, double stop = 10.0, double throttle_scale = 1.0);

/// time, torque, speed, shaft_speed, pitch: as the input `file` of a mechanism reads it.
void write_drive(const Monolithic& run, const std::filesystem::path& file);

}  // namespace tandem::kart
