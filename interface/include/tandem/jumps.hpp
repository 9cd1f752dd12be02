// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "tandem/signal.hpp"
#include "tandem/time_grid.hpp"

namespace tandem {

/// The inputs of one call, from one jump to the next: a one-step method that ends a step at each, and begins
/// the next on inputs that have jumped, keeps its order.
class Jumps {
 public:
  explicit Jumps(int inputs = 0) : from_jump_(static_cast<std::size_t>(inputs)) {}

  /// A call begins at t [s] on the inputs u, which outlive it.
  void begin(std::span<const Signal> u, double t) {
    u_ = u;
    find_next(t);
  }
  /// The first jump of an input that has not been passed yet [s]; infinite if there is none.
  double next() const { return next_; }
  /// The inputs from the last jump that was passed on.
  std::span<const Signal> inputs() const { return u_; }
  /// Goes on from next().
  void pass() {
    const double t = next_;
    std::transform(u_.begin(), u_.end(), from_jump_.begin(),
                   [t](const Signal& u) { return u.from_jump_at(t); });
    u_ = from_jump_;
    find_next(t);
  }

 private:
  void find_next(double t) {
    next_ = std::numeric_limits<double>::infinity();
    for (const Signal& u : u_) next_ = std::min(next_, u.next_jump(t));
  }

  std::vector<Signal> from_jump_;
  std::span<const Signal> u_;
  double next_ = std::numeric_limits<double>::infinity();
};

}  // namespace tandem
