// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tandem/signal.hpp"

namespace tandem {

/// A quantity over time that is known beforehand, by its values at points of time. A time that is there twice
/// is a jump, from the first value to the second, which holds at that time.
class TimeSeries {
 public:
  enum class Between {
    linear,  ///< straight lines
    hold,    ///< each value until the next one
    spline   ///< the natural cubic spline: value and two derivatives are continuous
  };
  enum class Beyond {
    refuse,  ///< it is not known there
    hold     ///< the first value, and the last
  };
  /// The words of files, in the order of the above.
  static constexpr std::array<std::string_view, 3> between_words = {"linear", "hold", "spline"};
  static constexpr std::array<std::string_view, 2> beyond_words = {"refuse", "hold"};
  struct How {
    Between between = Between::linear;
    Beyond beyond = Beyond::refuse;
  };

  /// name: what errors call it. Throws Error(invalid_argument) for fewer than two points, another number of
  /// values than of times, and what is not finite. It also refuses times that fall or are there three times,
  /// and for a spline a time that is there twice.
  TimeSeries(std::string name, std::span<const double> times, std::span<const double> values, How how);

  const std::string& name() const { return name_; }
  /// Where it is known [s]; infinite where the value beyond is held.
  double begin() const { return begin_; }
  double end() const { return end_; }
  /// Throws Error(numerical) for a time where it is not known; an end may be missed by rounding.
  void require(double t) const;

  /// One polynomial after the other, with its origin where it begins, and marked (tandem_segment_jumps) where
  /// the value jumps there.
  std::span<const Segment> pieces() const { return pieces_; }
  int degree() const { return degree_; }
  /// The piece that holds at t [s]; where one ends and the next begins, the next.
  const Segment& piece(double t) const;
  double value(double t) const { return polynomial(piece(t), t); }
  /// Of the pieces between two jumps, the run before the first being number 0, at t [s], also at its ends.
  double value(std::size_t run, double t) const;

  /// Times at which the value jumps, ascending, and at which its slope does and the value does not [s].
  std::span<const double> jumps() const { return jumps_; }
  std::span<const double> kinks() const { return kinks_; }

 private:
  using Points = std::span<const double>;
  static double polynomial(const Segment& s, double t) { return Signal(&s, 1, 0).value(t); }
  void check(Points times, Points values, Between between) const;
  void join(Points times, Points values, Between between);
  double value_before(Points times, Points values, std::size_t point) const;
  void add(const Segment& piece, bool jumps, bool smooth);

  std::string name_;
  double begin_ = -std::numeric_limits<double>::infinity(), end_ = -begin_;
  std::vector<Segment> pieces_;
  std::vector<double> jumps_, kinks_;
  std::vector<std::size_t> runs_ = {0};  ///< the first piece of each
  int degree_;
};

}  // namespace tandem
