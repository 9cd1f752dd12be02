// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>

#include "tandem/bytes.hpp"

namespace tandem {

/// Measures in a run whether the slow side accelerates as smoothly as its surrogate goes on: a contact, an inner mode, or too
/// long a step makes a bend within a step that no surrogate foresees.
class RestCheck {
 public:
  static constexpr double most = 0.2;
  /// At a node, t [s]: by how much the acceleration was off what had been foreseen, and how large it was.
  void take(double off, double size, double t) {
    largest_ = std::max(largest_, std::abs(size));
    if (std::abs(off) > worst_) worst_ = std::abs(off), at_ = t;
  }
  /// The largest of the first by the largest of the second; 0 before both.
  double error() const { return largest_ > 0.0 ? worst_ / largest_ : 0.0; }
  double at() const { return at_; }

  void write(ByteWriter& to) const { to.put(worst_), to.put(at_), to.put(largest_); }
  void read(ByteReader& from) {
    for (double* one : {&worst_, &at_, &largest_}) *one = from.take<double>();
  }

 private:
  double worst_ = 0.0, at_ = 0.0, largest_ = 0.0;
};

}  // namespace tandem
