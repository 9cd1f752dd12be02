// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "step_integrals.hpp"
#include "tandem/coordinator/impulse/defect_pulse.hpp"

namespace tandem {

/// One coordinate of a Taylor surrogate. Times s are since the slow side's last node [s].
class TaylorCoordinate {
 public:
  TaylorCoordinate(ForceWindow window, double z, double v)
      : z_(z), v_(v), at_(z), rate_(v), window_(window) {}

  double z() const { return z_; }
  double v() const { return v_; }
  double at() const { return at_; }  ///< of the slow side at its last node
  double rate() const { return rate_; }
  double foreseen() const { return foreseen_; }
  double foreseen_rate() const { return foreseen_rate_; }

  /// What is put in of the last defect, and what the polynomial lacks.
  double pulse(double s) const { return pulse_.acceleration(s); }
  double lacked(double s) const { return cubic_ * s * s * s; }

  /// A step of the classical Runge-Kutta method: the acceleration at its four stages, and the pulse there.
  void step(double h, const double (&a)[4], const double (&pulse)[3]);
  /// The acceleration of the first own step missed so much of these integrals.
  void make_up_start(const ForceIntegrals& missed) {
    integrals_.add(missed), z_ += missed.second, v_ += missed.first;
  }
  /// The slow side's node lies in the last step, h long, s before its end: the mean acceleration over the slow side's
  /// step, `length` long, which tells where that is to come to; next: the length of its coming step.
  double pass(double h, double s, double before, double now, double length, double next);
  /// What the slow side came to, s after that; lacks: by how much its acceleration there differs from the polynomial;
  /// jumps: a defect is put in at once.
  void take(double q, double u, double lacks, double s, double length, double next, bool jumps);
  /// The acceleration since the node, s ago, was off by so much.
  void make_up(double s, double a) { make_up_start({a * s, a * s * s / 2.0, a * s * s * s / 6.0}); }

  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  double z_, v_, at_, rate_, foreseen_ = 0.0, foreseen_rate_ = 0.0;
  double cubic_ = 0.0,
         sigma_ = 0.0;  ///< sigma: what it lacks at the last node, by the cube of the step before
  bool first_ = true;
  DefectPulse pulse_;
  StepIntegrals integrals_;  ///< of the acceleration without pulses
  ForceWindow window_;
};

}  // namespace tandem
