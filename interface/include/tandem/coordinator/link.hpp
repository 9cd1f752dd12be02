// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "tandem/coordinator/history.hpp"
#include "tandem/coordinator/reconstruction.hpp"
#include "tandem/time_grid.hpp"

namespace tandem {

/// One scalar output on its way to one scalar input of the reader: gain * output + offset.
struct Lane {
  int output;  ///< flattened index in the source
  int slot;    ///< where the reader's Signal is written
  double gain = 1.0, offset = 0.0;
};

/// All lanes from one source to one reader with the same reconstruction. Reconstructions that follow the
/// samples get one segment per sample of the source, with its origin at that sample (the segment's right
/// node), made once, when the sample is committed; so the signal depends on the samples alone, and many small
/// calls read what one large call reads. Mean and matched hold depend on the reader's step and are made when
/// it reads.
class Link {
 public:
  /// delay [s]: the reader gets at t what the source gave at t - delay.
  Link(int source, int reader, Reconstruction how, double delay);
  void add(Lane lane) { lanes_.push_back(lane); }

  int source() const { return source_; }
  int reader() const { return reader_; }
  const Reconstruction& how() const { return how_; }
  double delay() const { return delay_; }
  std::span<const Lane> lanes() const { return lanes_; }

  /// Forgets all segments and takes memory for as many samples as `source` has room for.
  void restart(const History& source, TimeTolerance tolerance);
  /// Makes the segments of the samples committed since the last call.
  void extend(const History& source);
  /// Follows a History::make_room that moved rows.
  void follow_room(const History& source);

  /// Writes a Signal into slots[lane.slot] for each lane, for a reader whose next own step is [time,
  /// next_time]. The signals are valid until the next call of any other member.
  void read(const History& source, double time, double next_time, Signal* slots) {
    if (!follows_) return read_window(source, time, next_time, slots);
    advance_cursor(time);
    const Segment* first = segments_.data() + (cursor_ - base_);
    const auto count = static_cast<std::int32_t>(end_ - cursor_);
    for (const Lane& lane : lanes_) {
      slots[lane.slot] = Signal(first, count, degree_);
      first += capacity_;
    }
  }

  /// The oldest row of the source that read() or extend() may still need for a reader that stands at `time`.
  std::int64_t oldest_needed(const History& source, double time);
  /// Lets the segments before the first one of full degree be forgotten, so that this one reaches back to the
  /// start (repeated start: interpolate in a pass that is complete).
  void reach_back();

 private:
  Segment* segments(std::size_t lane) {
    return segments_.data() + lane * static_cast<std::size_t>(capacity_);
  }
  void advance_cursor(double time) {
    const Segment* s = segments_.data() + (cursor_ - base_);
    for (; cursor_ < end_ - 1 && s->end < time; ++s) ++cursor_;
  }
  template <class Make>
  void extend_rows(const History& source, const Make& make);
  template <int Degree>
  void extend_lagrange(const History& source);
  void extend_hermite(const History& source);
  void extend_least_squares(const History& source);
  void read_window(const History& source, double time, double next_time, Signal* slots);
  void hold(const History& source, std::int64_t first, std::int64_t last, Signal* slots);

  int source_, reader_;
  Reconstruction how_;
  int degree_;    ///< of the polynomials
  bool follows_;  ///< how_.follows_samples()
  double delay_;
  std::vector<Lane> lanes_;

  TimeTolerance tolerance_;
  std::int64_t capacity_ = 0, base_ = 0;  ///< rows of segments, and the row of the first one
  std::int64_t end_ = 0;                  ///< one past the newest row that has a segment
  std::int64_t cursor_ = 0;               ///< row of the segment that holds the reader's time
  std::int64_t fit_from_ = 0;             ///< first row that may be fitted together with the newest one
  std::vector<Segment> segments_;         ///< by lane, then by row
  std::vector<double> differences_;       ///< by lane: backward divided differences at the newest row
};

}  // namespace tandem
