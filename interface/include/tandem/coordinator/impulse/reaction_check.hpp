// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <utility>

#include "tandem/bytes.hpp"

namespace tandem {

/// Measures in a run by how much the slow side answers a force otherwise than its surrogate does by A.
///
/// Its acceleration is A F + f(q, q'). A step of length H with the force F_n begins with A F_n + f_n and ends with
/// a_(n+1); the sample before it, with the force of that time, has a_n = A F_(n-1) + f_n. By the trapezoidal rule the sum of
/// the first two is 2 (v_(n+1) - v_n) / H, so
///
///     2 (v_(n+1) - v_n) / H - a_(n+1) - a_n = A (F_n - F_(n-1))
///
/// holds to the last digit, whatever f is. Another rule adds c H^2 f'', with c = -1/6 where it is exact. So both are fitted:
/// the share of A, which is to be 1, and c, for the second difference of f = a - A F.
class ReactionCheck {
 public:
  /// a: the acceleration at the start, where the force is 0.
  explicit ReactionCheck(double a) : acceleration_(a), free_{a, a} {}

  /// Of a force by which the slow side takes its step: its change since the step before.
  double change_to(double force) { return force - std::exchange(force_, force); }
  /// After that step: the change of velocity over so long, the acceleration at its end, and A times the forces and
  /// times their change.
  void take(double velocity_change, double length, double acceleration, double answer, double change);

  /// By how much the share of A is off 1, beyond three standard errors, of few steps more (W. S. Gosset's distribution,
  /// roughly). 0 also where the changes of the force are less than a tenth of what is measured. A hundredth of what c makes counts as scatter.
  /// Steps count the less the longer they are ago, 20 of them altogether. 0 for the first six.
  double error() const;

  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  std::array<double*, 16> numbers() {
    return {&acceleration_, &force_, &free_[0], &free_[1], &taken_, &measured_, &change_, &second_,
            &largest_,      &count_, &cc_,      &cf_,      &ff_,    &cm_,       &fm_,     &mm_};
  }
  void add(double f);

  double acceleration_, force_ = 0.0;  ///< of the step before
  double free_[2];                     ///< f at the last node, and at the one before
  double taken_ = 0.0, measured_ = 0.0, change_ = 0.0,
         second_ = 0.0;   ///< steps; of the last one, which waits for the next
  double largest_ = 0.0;  ///< change that A has given
  double count_ = 0.0;
  /// Sums over steps: of products of the change that A gives, the second difference of f and what was measured.
  double cc_ = 0.0, cf_ = 0.0, ff_ = 0.0, cm_ = 0.0, fm_ = 0.0, mm_ = 0.0;
};

}  // namespace tandem
