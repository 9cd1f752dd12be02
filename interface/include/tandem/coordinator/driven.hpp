// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

#include "tandem/time_series.hpp"

namespace tandem {

/// A scalar input that is known over the whole run: which pieces its reader is given in a call.
class Driven {
 public:
  /// slot: of the reader's inputs. The run begins at t_start [s], for which `tolerance` is made.
  Driven(const TimeSeries& series, std::size_t slot, TimeTolerance tolerance, double t_start);

  std::size_t slot() const { return slot_; }
  /// For a call from `time` to `limit`; whoever stands at a jump, give or take the tolerance, is given what
  /// begins there. Calls with ascending times take no search. Valid as long as this lives.
  Signal over(double time, double limit);
  /// At the instant of a sampled reader: at a jump the value after it.
  double at(double time) { return over(time, time).value(time); }
  bool jumps_at(double time) const;

 private:
  bool is_past(std::size_t piece, double time) const;

  std::vector<Segment> pieces_;  ///< ends are widened by the tolerance, as those of links are
  std::size_t slot_, first_ = 0;
  int degree_;
  TimeTolerance tolerance_;
};

}  // namespace tandem
