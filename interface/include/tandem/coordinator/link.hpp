// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "tandem/coordinator/history.hpp"
#include "tandem/coordinator/lane.hpp"
#include "tandem/coordinator/lines.hpp"
#include "tandem/coordinator/member.hpp"
#include "tandem/coordinator/reconstruction.hpp"
#include "tandem/time_grid.hpp"

namespace tandem {

/// All lanes from one source to one reader with the same reconstruction.
///
/// Reconstructions that follow the samples get one segment per sample of the source. The segment has its
/// origin at that sample (the segment's right node); the segment of a held output has it at its begin, the
/// sample's time. Each segment is made once, when the sample is committed. So the signal depends on the
/// samples alone, and many small calls read what one large call reads. Mean and matched hold depend on the
/// reader's step and are made when it reads.
///
/// It is one class for all kinds, and long for that, as a time loop reads links without a virtual call; each
/// kind has a source file of its own.
class alignas(64) Link {
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
  /// Its source has samples besides those at its own nodes, or jumps. Before attach().
  /// - A sample is passed over if it is nearer than `nearest` [s], above 0, to the next newer one that a
  ///   polynomial goes through.
  /// - After a jump of a lane its polynomials go through the samples from the jump on, and the segment there
  ///   is marked.
  /// - What is interpolated between two samples of which the older is passed over joins them all the same, as
  ///   the reader has stood there. The polynomial goes through both; another goes on behind the newer one.
  /// - With degree 0 a line joins them, where an own step of `2 nearest` was cut.
  void pass_over(double nearest);
  /// Its source has events, or jumps with those of another. Before attach().
  void expect_jumps() { has_events_ = true; }
  /// Its source will jump at t, or (-Member::never) is not expected to any more.
  void expect_jump(double t) {
    if (has_events_) expected_ = t + delay_;
  }
  /// Makes the segments of the samples committed last.
  void extend(NewRows rows) { extend_(*this, rows); }
  /// Samples that were committed, and whose segments are made later, by extend_late().
  void wait(std::int64_t rows) { late_ += rows; }
  void extend_late();
  /// By how much, at most, an input jumps at the newest row of the source.
  double newest_jump() const;
  /// Its source takes its newest `rows` rows back.
  void withdraw(std::int64_t rows);
  /// Its reader goes back: makes the segments of all rows that are there anew.
  void rebuild();
  /// Follows a History::make_room of its source.
  void follow_room();

  /// Writes a Signal into slots[lane.slot] for each lane, for a reader whose next own step is [time,
  /// next_time]. The signals are valid until the next call of any other member.
  void read(double time, double next_time, Signal* slots) {
    been_read_ = true;
    if (!plain_) return read_otherwise(time, next_time, slots);
    forget_before(time);
    const Segment* s = first_;
    for (const Lane& lane : lanes_) {
      slots[lane.slot] = Signal(s, count_, degree_);
      s += capacity_;
    }
  }

  /// The reader is sampled. within: the source depends on it, so it reads nothing that was given after its
  /// instant; just_before: of a held output it reads the value before its instant. Before attach().
  void read_at_instants(bool within, bool just_before) {
    sampled_ = true, within_ = within, just_before_ = just_before;
  }
  bool just_before() const { return just_before_; }
  /// What a sampled reader gets at its instant `to.stop`, having acted at `to.start`: u[lane.slot] for each
  /// lane.
  void sample(TimeSpan to, double* u);
  /// When it is known to jump next after `time`: of a sampled source its next sample, of one with events its
  /// next jump; `never` if that is not known.
  double next_break(double time) const;
  /// Whether it jumps at `time`, which its reader has not read yet.
  bool jumps_at(double time) const;
  /// The newest row has other values now than when its segments were made.
  void remake(const double* row);

  /// The oldest row of the source that extend() may still need, or read() for a reader that stands at `time`;
  /// all of them before the first read.
  std::int64_t oldest_needed(double time);
  /// The oldest row that rebuild() needs for a reader that goes back to `time`.
  std::int64_t oldest_to_rebuild(double time) const;
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
  /// A held value ends where the next begins: who stands there, give or take the tolerance, reads the next.
  void forget_held(double time) {
    for (; count_ > 1 && !tolerance_.before(time, first_[1].origin); --count_) ++first_;
  }
  /// Likewise, where one of the lanes jumps.
  void forget_to(double time) {
    while (count_ > 1 &&
           (first_->end < time || (!tolerance_.before(time, first_[1].origin) && jumps_in(first_ + 1))))
      --count_, ++first_;
  }
  /// Whether that segment of lane 0, or one beside it, begins with a jump.
  bool jumps_in(const Segment* of_first) const;
  double next_jump(double time) const;
  bool is_past(double t) const;
  /// Whether t lies behind the last sample, for which there is a segment of its own.
  bool is_past_last(double t) const { return goes_on_ && count_ == 1 && first_->end < t; }
  using Extend = void (*)(Link&, NewRows rows);
  static Extend extend_by(Reconstruction how);
  template <int Degree>
  static void extend_lagrange(Link& link, NewRows rows);
  static void extend_held(Link& link, NewRows rows);
  static void extend_hermite(Link& link, NewRows rows);
  static void extend_taylor(Link& link, NewRows rows);
  static void extend_least_squares(Link& link, NewRows rows);
  template <class Make, class Join>
  void extend_rows(NewRows rows, const Make& make, const Join& join);
  template <class Make, class Join>
  void extend_spread(NewRows rows, const Make& make, const Join& join);
  template <class Make>
  void fit_lanes(const double* row, Segment* to, bool joined, const Make& make);
  template <class Make>
  void fit(const double* row, Segment* to, std::span<const Lane> lanes, const Make& make);
  void gather_nodes(const double* row, const Lane* lane, bool joined);
  bool joins_step_to(const double* row) const;
  void go_on_behind(std::int32_t last);
  void renew_last();
  std::int64_t segments_of_lane() const { return samples_->capacity() + (joins_ ? 1 : 0); }
  bool jump_near(const double* row) const;
  bool spreads() const { return nearest_ > 0.0; }
  int rows_looked_at() const { return (spreads() ? 4 : 1) * how_.samples(); }
  int rows_kept() const { return rows_looked_at() + (spreads() ? 1 : 0); }  ///< a jump's takes that before it
  bool jumps(const double* row, const Lane& lane) const;
  std::int32_t let_go() const;
  void check(std::int32_t count, std::int32_t old, const ByteReader& from) const;
  void read(std::span<Segment> lane, ByteReader& from) const;
  void read_otherwise(double time, double next_time, Signal* slots);
  void read_window(double time, double next_time, Signal* slots);
  void sample_window(TimeSpan to, double* u);
  struct Rows {
    std::int64_t first, last;
  };
  Rows window(double time, double next_time) const;
  double value(std::int64_t row, const Lane& lane) const {
    return samples_->values(row)[static_cast<std::size_t>(lane.output)];
  }
  double mean(const Lane& lane, Rows rows, TimeSpan span) const;
  double line_mean(const Lane& lane, std::int64_t row, TimeSpan span) const;
  double held_mean(const Lane& lane, Rows rows, TimeSpan span) const;

  // What a turn touches, in two lines of the cache: what is read, and what is extended beside it.
  Segment* first_ = nullptr;   ///< Of lane 0: the segment that holds the reader's time.
  std::int64_t capacity_ = 0;  ///< Segments that there is room for in a lane.
  std::int32_t count_ = 0;     ///< Segments from first_ on.
  std::int32_t degree_;        ///< Of the polynomials.
  bool follows_;               ///< `how_.follows_samples()`.
  bool held_;                  ///< `how_.kind` is held.
  bool plain_;                 ///< It is read as it is: neither held nor made when it is read.
  bool been_read_ = false;
  std::vector<Lane> lanes_;
  Extend extend_;
  std::int64_t stride_ = 0;  ///< Of the source's rows.
  std::int64_t fitted_ = 0;  ///< Rows that may be fitted together with the next one.
  double nearest_ = 0.0;     ///< See pass_over.
  double delay_;
  TimeTolerance tolerance_;
  std::vector<double> differences_;  ///< By lane: backward divided differences at the newest row.

  const History* samples_ = nullptr;
  LineVector<Segment> segments_;  ///< By lane, then by row.
  int source_, reader_;
  Reconstruction how_;
  bool has_events_ = false;           ///< Its source has.
  double expected_ = -Member::never;  ///< Time [s]: see expect_jump.
  bool joins_ = false;                ///< See pass_over.
  bool goes_on_ = false;              ///< Behind the last segment one more, for what is past the last sample.
  std::vector<double> nodes_;         ///< Rows that a polynomial goes through, where some are passed over.
  int gathered_ = 0;                  ///< Of them, at the end.
  std::int64_t late_ = 0;             ///< See wait().
  bool sampled_ = false, within_ = false, just_before_ = false;  ///< See read_at_instants.
  double read_from_ = 0.0;  ///< Begin of the window that a sampled reader read last.
};

}  // namespace tandem
