// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tandem::kart {

/// The kart of scenarios/kart/README.md, SI units; "front" and "rear" of one wheel, but for spin inertias,
/// which are of an axle.
struct KartData {
  double mass = 250.0, sprung = 206.0, front_unsprung = 9.0, rear_unsprung = 13.0;
  double height = 0.25, sprung_height = 0.2737;  ///< of the centres of mass
  double to_front = 0.645, to_rear = 0.400;      ///< axles from the centre of mass
  double sprung_to_front = 0.6509, sprung_to_rear = 0.3941;
  double pitch_inertia = 19.0;  ///< of the sprung mass
  double front_stiffness = 5800.0, rear_stiffness = 7300.0, front_damping = 150.0, rear_damping = 185.0;
  double front_tyre = 64.5e3, rear_tyre = 61.3e3, tyre_damping = 300.0;
  double radius = 0.139, front_spin = 0.08, rear_spin = 0.22;
  double drag = 0.5 * 1.2 * 0.7;  ///< drag = this times v^2
  double rolling = 0.02, relaxation = 0.15, gravity = 9.81;

  double front_load() const { return mass * gravity * to_rear / (to_front + to_rear); }  ///< of the axle
  double rear_load() const { return mass * gravity * to_front / (to_front + to_rear); }
};

}  // namespace tandem::kart
