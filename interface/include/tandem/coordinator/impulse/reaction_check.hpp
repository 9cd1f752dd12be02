// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>

#include "tandem/bytes.hpp"

namespace tandem {

/// Measures in a run by how much the slow side answers a force otherwise than its surrogate does by A.
///
/// Its acceleration is A F + f(q, q'). A step of length H with the force F_n begins with A F_n + f and ends with
/// a_(n+1); the sample before it, with the force of that time, has a_n = A F_(n-1) + f. By the trapezoidal rule the sum of the
/// first two is 2 (v_(n+1) - v_n) / H, so
///
///     2 (v_(n+1) - v_n) / H - a_(n+1) - a_n = A (F_n - F_(n-1))
///
/// holds to the last digit, whatever f is. Another rule is off by H^2 f'' / 6, which the scatter of these
/// samples tells.
class ReactionCheck {
 public:
  /// a: the acceleration at the start, where the force is 0.
  explicit ReactionCheck(double a) : acceleration_(a) {}

  /// Of a force by which the slow side takes its step: its change since the step before.
  double change_to(double force) { return force - std::exchange(force_, force); }
  /// After that step: the change of velocity over so long, the acceleration at its end, and A times the change
  /// of the forces.
  void take(double velocity_change, double length, double acceleration, double expected);

  /// By how much the slope of what was measured over what was expected is off 1, beyond three standard errors. Steps count
  /// the less the longer they are ago, 20 of them altogether. 0 for the first three.
  double error() const;

  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  double acceleration_, force_ = 0.0;                                   ///< of the step before
  double count_ = 0.0, square_ = 0.0, product_ = 0.0, measured_ = 0.0;  ///< sums over steps
};

}  // namespace tandem
