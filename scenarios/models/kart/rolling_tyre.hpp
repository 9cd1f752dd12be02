// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

#include "kart/tyres.hpp"
#include "tandem/mbs/mechanism/force_element.hpp"

namespace tandem::kart {

/// The arm by which the force along the wheel turns it: that of slip, or the height of the centre.
enum class Lever { radius, height };

/// What the tyres of a file have in common.
struct TyreData {
  TyreLaw law;
  Axle axle;
  Lever lever;
  double radius, free_radius, stiffness, damping, rolling, relaxation;

  static TyreData from(mbs::ElementKeys& keys);
  static void keys(text::KeyList& to);  ///< those that it reads

  /// At a height of the centre over the ground [m], rising with `rate` [m/s].
  double load(double height, double rate) const;
  double excess(double load) const;  ///< beyond the data of its law [N]; 0 if it has none
  /// Couple against rolling [N m] and its derivative by the spin [rad/s].
  double resistance(double load, double spin) const;
  double resistance_rate(double load, double spin) const;
  /// Of a brake's couple, at a spin over its upright [rad/s], and d gripping / d spin where it is `part` [s].
  double gripping(double spin) const;
  double gripping_rate(double part) const;
  double potential(double height) const;  ///< [J]
  /// What the damper takes of a load whose centre rises with `rate` [W].
  double damping_loss(double height, double rate) const;
  /// Slip where the state is kappa and the tyre slides with s on the ground, over which it moves with v
  /// [m/s].
  static double slip(double kappa, double s, double v);
  static double damping_of_slip(double v);  ///< d slip / d s [s/m]
  double slip_rate(double kappa, double s, double v) const;
  /// Derivatives of both forces (rows) by both slips, where the forces are those.
  Eigen::Matrix2d slopes(const Slip& slip, double load, const TyreForce& there) const;
};

}  // namespace tandem::kart
