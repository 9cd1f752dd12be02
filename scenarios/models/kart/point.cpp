// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/point.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::kart {
namespace {

double rolling_mass(const KartData& d) {
  return d.mass + (d.front_spin + d.rear_spin) / (d.radius * d.radius);
}

double pitch_stiffness(const KartData& d) {
  return 2.0 * (d.front_stiffness * d.to_front * d.to_front + d.rear_stiffness * d.to_rear * d.to_rear);
}

}  // namespace

Point::Point(const KartData& data) : KartModel({"x"}, {rolling_mass(data)}), data_(data) {}

void Point::forces(const double*, const double* v, double* force) const {
  const KartData& d = data_;
  *force =
      torque / d.radius - d.drag * *v * std::abs(*v) - d.rolling * d.mass * d.gravity * std::tanh(*v / 0.1);
}

double Point::energy(const double*, const double* v) const { return 0.5 * rolling_mass(data_) * *v * *v; }

SubsystemInfo Point::info() const {
  return {"kart.point",
          {{"torque", "N m"}},
          {{"shaft_speed", "rad/s", 1, 1}, {"pitch", "rad"}, {"speed", "m/s", 1, 1}},
          {{1, 0}},
          {}};
}

void Point::outputs(const mbs::State& s, double* y) const {
  const double v = s.v[0], a = s.a[0], r = data_.radius,
               pitch = -data_.mass * a * data_.height / pitch_stiffness(data_);
  const double row[] = {v / r, pitch, v, a / r, 0.0, a};
  std::copy(std::begin(row), std::end(row), y);
}

}  // namespace tandem::kart
