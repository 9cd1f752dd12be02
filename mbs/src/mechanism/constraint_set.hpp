// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>
#include <vector>

#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

/// Equations of one kind, evaluated in one loop: theirs are size() equations from first_ on. Coordinates are
/// indices into q; entries of fixed coordinates are written where nobody reads.
class ConstraintSet {
 public:
  virtual ~ConstraintSet() = default;
  virtual int size() const = 0;
  /// The coordinates that an equation of the set depends on, in the order in which values() writes.
  virtual std::vector<int> coordinates(int equation) const = 0;

  /// phi of all equations of the mechanism, and the values of its Jacobian.
  virtual void values(const double* q, double* phi, double* jacobian) const = 0;
  /// Partial derivatives by time, of equations that have one.
  virtual void rates(double*) const {}
  /// gamma in Phi'' = Phi_q q'' + gamma.
  virtual void accelerations(const double* q, const double* v, double* gamma) const = 0;
  /// Model::off() of one of its equations.
  virtual Off off(int /*equation*/, const double* /*q*/, double phi) const { return {phi, 1.0}; }

  /// first: number of the set's first equation. to: for each of its entries the position in the Jacobian.
  void place(int first, std::vector<int> to) {
    first_ = first;
    to_ = std::move(to);
  }

 protected:
  int first_ = 0;
  std::vector<int> to_;
};

}  // namespace tandem::mbs
