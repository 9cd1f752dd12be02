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
  Link(Link&&) = default;
  void add(Lane lane) { lanes_.push_back(lane); }

  int source() const { return source_; }
  int reader() const { return reader_; }
  const Reconstruction& how() const { return how_; }
  double delay() const { return delay_; }
  std::span<const Lane> lanes() const { return lanes_; }

  /// Takes memory for as many samples as there is room for in `samples`, the source's; they must outlive the
  /// link. Before anything below.
  void attach(const History& samples, TimeTolerance tolerance);
  /// Makes the segments of the samples committed last.
  void extend(NewRows rows) { extend_(*this, rows); }
  /// Follows a History::make_room of its source.
  void follow_room();

  /// Writes a Signal into slots[lane.slot] for each lane, for a reader whose next own step is [time,
  /// next_time]. The signals are valid until the next call of any other member.
  void read(double time, double next_time, Signal* slots) {
    been_read_ = true;
    if (!follows_) return read_window(time, next_time, slots);
    forget_before(time);
    const Segment* s = first_;
    for (const Lane& lane : lanes_) {
      slots[lane.slot] = Signal(s, count_, degree_);
      s += capacity_;
    }
  }

  /// The oldest row of the source that extend() may still need, or read() for a reader that stands at `time`;
  /// all of them before the first read.
  std::int64_t oldest_needed(double time);
  /// Lets the segments before the first one of full degree be forgotten, so that this one reaches back to the
  /// start (repeated start: interpolate in a pass that is complete).
  void reach_back();

  /// What the next segments and reads go by, for a checkpoint, and back, after History::read of its source.
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  void forget_before(double time) {
    for (; count_ > 1 && first_->end < time; --count_) ++first_;
  }
  using Extend = void (*)(Link&, NewRows rows);
  static Extend extend_by(Reconstruction how);
  template <int Degree>
  static void extend_lagrange(Link& link, NewRows rows);
  static void extend_hermite(Link& link, NewRows rows);
  static void extend_least_squares(Link& link, NewRows rows);
  template <class Make>
  void extend_rows(NewRows rows, const Make& make);
  void check(std::int32_t count, const ByteReader& from) const;
  static void read(std::span<Segment> lane, ByteReader& from);
  void read_window(double time, double next_time, Signal* slots);
  void hold(std::int64_t first, std::int64_t last, Signal* slots);

  int source_, reader_;
  Reconstruction how_;
  Extend extend_;
  int degree_;    ///< of the polynomials
  bool follows_;  ///< how_.follows_samples()
  double delay_;
  std::vector<Lane> lanes_;

  TimeTolerance tolerance_;
  const History* samples_ = nullptr;
  std::int64_t stride_ = 0;    ///< of their rows
  std::int64_t capacity_ = 0;  ///< segments that there is room for in a lane
  Segment* first_ = nullptr;   ///< of lane 0: the segment that holds the reader's time
  std::int32_t count_ = 0;     ///< segments from there on
  std::int64_t fitted_ = 0;    ///< rows that may be fitted together with the next one
  bool been_read_ = false;
  std::vector<Segment> segments_;    ///< by lane, then by row
  std::vector<double> differences_;  ///< by lane: backward divided differences at the newest row
};

}  // namespace tandem
