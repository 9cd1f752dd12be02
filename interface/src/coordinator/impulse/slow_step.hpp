// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <string>

#include "tandem/error.hpp"
#include "tandem/signal.hpp"
#include "tandem/time_grid.hpp"

namespace tandem {

/// The step of the slow side that a surrogate goes through [s]: from its last node to the next one, or to where the run ends.
class SlowStep {
 public:
  void end_at(double t_stop) { t_stop_ = t_stop; }
  void start(double t, double length) {
    tolerance_ = TimeTolerance(t);
    length_ = length;
    begin_at(t);
  }
  void begin_at(double t) { begin_ = t, end_ = std::min(t + length_, t_stop_); }
  /// It stands at its begin: the step has ended there.
  void make_end_of_begin() { end_ = begin_, begin_ -= length_; }

  double begin() const { return begin_; }
  double end() const { return end_; }
  double length() const { return end_ - begin_; }
  bool goes_on_after(double t) const { return tolerance_.before(t, end_); }

  /// The slow side stands at its newest sample. Throws Error(not_supported) if that is not at t.
  void require_slow_side_at(double t, const Signal& of_slow_side) const {
    const double at = of_slow_side.segments().back().origin;
    if (!tolerance_.before(at, t) && !tolerance_.before(t, at)) return;
    throw Error(ErrorCode::not_supported,
                "impulse coupling: the slow side stands at " + std::to_string(at) +
                    " s where it is to stand at " + std::to_string(t) +
                    " s; allowed is an order in which the surrogate and the fast sides lead it");
  }

 private:
  double t_stop_ = 0.0, length_ = 0.0, begin_ = 0.0, end_ = 0.0;
  TimeTolerance tolerance_;
};

}  // namespace tandem
