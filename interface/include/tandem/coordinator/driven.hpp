// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

#include "tandem/bytes.hpp"
#include "tandem/time_series.hpp"

namespace tandem {

/// A scalar input that no other subsystem gives: one that is known over the whole run, or an open one, which is
/// known as far as who runs the coordinator has told it. It gives its reader the pieces for a call.
class Driven {
 public:
  /// slot: of the reader's inputs. The run begins at t_start [s], for which `tolerance` is made.
  Driven(const TimeSeries& series, std::size_t slot, TimeTolerance tolerance, double t_start);
  /// An open one, which is `value` until more is known. at_instants: its reader is sampled.
  Driven(double value, std::size_t slot, TimeTolerance tolerance, bool at_instants);

  std::size_t slot() const { return slot_; }
  bool is_open() const { return open_; }
  /// Of an open one: from t [s] on it is `u`, the last piece of which goes on. It jumps at t if it is
  /// another number than before, by 1e-9 of it, and `u` says so or is constant.
  void go_on(double t, const Signal& u);
  /// Of an open one: its reader has read the jump where it stands.
  void forget_jump();
  /// For a call from `time` to `limit`; whoever stands at a jump, give or take the tolerance, is given what
  /// begins there. Calls with ascending times take no search. Valid as long as this lives.
  Signal over(double time, double limit);
  /// At the instant of a sampled reader: at a jump the value after it.
  double at(double time) { return over(time, time).value(time); }
  bool jumps_at(double time) const;

  /// Of an open one, for a checkpoint.
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  bool is_past(std::size_t piece, double time) const;
  bool jumps_to(double t, const Signal& u) const;
  void append(double t, const Signal& u);

  std::vector<Segment> pieces_;  ///< ends of known ones are widened by the tolerance, as those of links are
  std::size_t slot_, first_ = 0;
  int degree_;
  TimeTolerance tolerance_;
  bool open_ = false, at_instants_ = false;
};

}  // namespace tandem
