// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tandem {

class ByteReader;
class ByteWriter;

/// From `start` to `stop` [s].
struct TimeSpan {
  double start, stop;
};

/// The one tolerant comparison of times. A node t = t_start + k h is rounded three times: the step h and the
/// product by eps/2 |k h| each, the sum by eps/2 |t|. With S = max(|t|, |t_start|), |k h| <= 2 S, so a node
/// is off by at most 2.5 eps S, and two grids that meet by their definition, n h2 = k h1, differ by at most
/// 5 eps S (2 eps S from t_start = 0). 6 eps S tells "equal" from "before".
class TimeTolerance {
 public:
  explicit TimeTolerance(double t_start = 0.0) : t_start_(std::abs(t_start)) {}

  /// Width within which a and b are the same time [s].
  double width(double a, double b) const {
    return 6.0 * std::numeric_limits<double>::epsilon() *
           std::max(std::max(std::abs(a), std::abs(b)), t_start_);
  }
  /// a lies before b by more than the tolerance. Of finite times: with an infinite one it is false.
  bool before(double a, double b) const { return a < b && a < b - width(a, b); }

 private:
  double t_start_;
};

/// Own steps of fixed length h: node k is t_start + k h, multiplied and never accumulated. It keeps the place
/// of a subsystem on that grid, also after a step that was cut short (the grid stays as it was).
class TimeGrid {
 public:
  TimeGrid() = default;
  /// Stands at node 0. Throws Error if h is not finite and positive, or too small for t_start + h to differ
  /// from t_start.
  TimeGrid(double t_start, double h);

  double node(std::int64_t k) const { return t_start_ + static_cast<double>(k) * h_; }
  double time() const { return time_; }
  /// The node at which the next own step ends.
  double next() const { return next_; }
  /// Length of the next own step [s]: h, or what is left of it after a cut.
  double length() const { return whole_ ? h_ : next_ - time_; }
  double h() const { return h_; }

  /// True if the next own step ends at or before t_limit.
  bool fits(double t_limit) const { return !tolerance_.before(t_limit, next_); }
  /// True if t_limit lies inside the next own step, so that the step would have to be cut to end there.
  bool cuts(double t_limit) const { return !fits(t_limit) && tolerance_.before(time_, t_limit); }
  const TimeTolerance& tolerance() const { return tolerance_; }

  /// Moves on to next().
  void step() {
    time_ = next_;
    next_ = node(++index_);
    whole_ = true;
  }
  /// Moves on to t, inside the next own step; next() stays the same node.
  void cut(double t) {
    time_ = t;
    whole_ = false;
  }

  /// Its place, for a state that leaves the process, and back. Refuses that of another grid.
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  double t_start_ = 0.0, h_ = 1.0, time_ = 0.0, next_ = 1.0;
  std::int64_t index_ = 1;
  bool whole_ = true;
  TimeTolerance tolerance_;
};

}  // namespace tandem
