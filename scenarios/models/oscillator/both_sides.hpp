// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Dense>

#include "tandem/fixed_step.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::oscillator {

/// The exact motion of both oscillators of side.hpp, undivided: z(t) = exp(A (t - t0)) z(t0), z = (x1, v1, x2, v2).
/// Outputs x1 (with x1', x1''), v1 (with x1''), x2, v2 likewise.
class BothSides {
 public:
  using State = Eigen::Vector4d;

  /// rates: A [SI]. at_start: z(t0). step: h [s].
  BothSides(const Eigen::Matrix4d& rates, const State& at_start, double step)
      : rates_(rates), at_start_(at_start), state_(at_start), step_(step) {}
  /// Takes m1, c1, d1 of side 1, m2, c2, d2, the coupling's c and d, and x1, v1, x2, v2, step.
  static BothSides from(Parameters& parameters);
  static Words words();

  SubsystemInfo info() const;
  double own_step() const { return step_; }
  void start(double t, std::span<const double> u0);
  void step(const OwnStep& s, std::span<const Signal> u);
  void outputs(double* y) const;
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  Eigen::Matrix4d rates_;
  State at_start_, state_;
  double step_, t0_ = 0.0;
};

}  // namespace tandem::oscillator
