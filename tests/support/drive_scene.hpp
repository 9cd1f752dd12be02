// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The exact motion of scenarios/drive: motor, load, speed controller and weight, linear between samples.
#pragma once
#include "exact_samples.hpp"

namespace tandem::test {

/// The values of the scenario files.
struct Drive {
  double R = 0.5, L = 2e-3, k = 0.8, kp = 4.0, ki = 1000.0;                ///< motor, current loop
  double J_motor = 0.05, J_drum = 0.2, stiffness = 2402.0, damping = 0.4;  ///< load
  double speed_kp = 7.0, speed_ki = 87.5, set = 10.0, period = 2.5e-3;     ///< speed controller
  double weight = 40.0, at = 0.31373;
};

enum DrivePart { drive_motor, drive_load, drive_controller, drive_weight };

/// States i and z of the current loop; inputs i_ref and w; output torque.
inline Part motor_part(const Drive& d) {
  MatrixXd a(2, 2), b(2, 2), c(1, 2);
  a << -(d.kp + d.R) / d.L, d.ki / d.L, -1.0, 0.0;
  b << d.kp / d.L, -d.k / d.L, 1.0, 0.0;
  c << d.k, 0.0;
  return {{a, b, c, MatrixXd::Zero(1, 2), VectorXd::Zero(2)}};
}

/// States and outputs speed, drum speed, twist; inputs torque and load.
inline Part load_part(const Drive& d) {
  MatrixXd a(3, 3), b(3, 2);
  a << -d.damping / d.J_motor, d.damping / d.J_motor, -d.stiffness / d.J_motor,  //
      d.damping / d.J_drum, -d.damping / d.J_drum, d.stiffness / d.J_drum,       //
      1.0, -1.0, 0.0;
  b << 1.0 / d.J_motor, 0.0, 0.0, -1.0 / d.J_drum, 0.0, 0.0;
  return {{a, b, MatrixXd::Identity(3, 3), MatrixXd::Zero(3, 2), VectorXd::Zero(3)}};
}

/// States the integral and the set speed, which makes e = set - w linear; input w; output i_ref.
inline Part controller_part(const Drive& d) {
  const double gain = d.speed_ki * d.period;
  MatrixXd a(2, 2), b(2, 1), c(1, 2), feedthrough(1, 1);
  a << 1.0, gain, 0.0, 1.0;
  b << -gain, 0.0;
  c << 1.0, d.speed_kp;
  feedthrough << -d.speed_kp;
  return {{a, b, c, feedthrough, Eigen::Vector2d(0.0, d.set)}, LinearController::Times{d.period}};
}

/// Gives 0 at the first of its instants, at t = 0, and the load from the second on.
inline Part weight_part(const Drive& d) {
  MatrixXd a(2, 2), c(1, 2);
  a << 0.0, 1.0, 0.0, 1.0;
  c << 1.0, 0.0;
  return {{a, MatrixXd::Zero(2, 0), c, MatrixXd::Zero(1, 0), Eigen::Vector2d(0.0, d.weight)},
          LinearController::Times{d.at}};
}

inline ExactSamples exact_drive(const Drive& d = {}) {
  return {{motor_part(d), load_part(d), controller_part(d), weight_part(d)},
          {{drive_controller, 0, drive_motor, 0},
           {drive_load, 0, drive_motor, 1},
           {drive_motor, 0, drive_load, 0},
           {drive_load, 0, drive_controller, 0},
           {drive_weight, 0, drive_load, 1}},
          0.0};
}

}  // namespace tandem::test
