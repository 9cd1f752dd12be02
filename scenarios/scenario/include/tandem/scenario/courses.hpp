// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "tandem/text/time_table.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::scenario {

/// A column of a table as a function of time.
struct Course {
  /// Between a row and the next, y + s (d + s (c + s e)) with s from 0 to 1.
  struct Cubic {
    std::size_t row;  ///< the next; 0: none yet
    double y, d, c, e;
  };
  std::size_t values;
  std::optional<std::size_t> derivatives;  ///< Its column der(NAME), where there is one.
  mutable Cubic cubic = {};                ///< The one that somebody asked for last.
};

/// The columns of a table as functions of time, at times that are asked for in rising order.
class Courses {
 public:
  explicit Courses(const text::TimeTable& table);

  bool has(const std::string& name) const { return index_.contains(name); }
  /// Throws Error with the nearest name.
  Course course(const std::string& name) const;
  bool covers(double t) const {
    return !tolerance_.before(t, table_.times.front()) && !tolerance_.before(table_.times.back(), t);
  }
  std::size_t count_between(double begin, double end) const;

  /// again: the second row of this time is wanted, if there is one.
  void move_to(double t, bool again);
  /// Whether there is a row at the time that was moved to.
  bool exact() const { return exact_; }
  /// By Hermite polynomials between rows with derivatives, else by straight lines.
  double value(const Course& course) const;
  /// The derivative of that polynomial. Precondition: it has derivatives.
  double slope(const Course& course) const;

 private:
  const Course::Cubic& cubic(const Course& course) const;

  const text::TimeTable& table_;
  TimeTolerance tolerance_;
  std::unordered_map<std::string_view, std::size_t> index_;
  std::size_t row_ = 0;
  bool exact_ = true;
  double length_ = 0.0, s_ = 0.0;  ///< between the row before and this one [s], and where the time is in it
};

}  // namespace tandem::scenario
