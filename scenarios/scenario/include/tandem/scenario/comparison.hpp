// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "tandem/text/time_table.hpp"

namespace tandem::scenario {

using text::TimeTable;

/// Of a difference over time: its largest magnitude, or its root mean square over the compared times.
enum class Norm { max, rms };

/// How the difference of two results is measured.
struct Measure {
  Norm norm = Norm::max;  ///< that a tolerance is of
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();  ///< [s]: the times of B that count
  double shift = 0.0;  ///< [s]: A may be so much earlier or later than B as a whole
  /// Straight lines count where one has no row and no derivative; else such times are left out.
  bool lines = true;

  bool operator==(const Measure&) const = default;
};

/// How one column of two results differs.
struct Difference {
  std::string column;
  double time = 0.0;  ///< Time of A where it differs most [s].
  double a = 0.0, b = 0.0;
  double absolute = 0.0;  ///< The difference |a - b|.
  double peak = 0.0;  ///< Largest magnitude of the column in B at the times that count (in A where it is 0).
  double relative = 0.0;      ///< `absolute`, divided by `peak`.
  double rms = 0.0;           ///< Of a - b over the compared times.
  double rms_of = 0.0;        ///< Of the column in B at these times (in A where it is 0).
  double relative_rms = 0.0;  ///< `rms`, divided by `rms_of`.
  double end = 0.0;           ///< The difference |a - b| at the last compared time.
  std::size_t compared = 0;   ///< Values.

  double size(Norm norm) const { return norm == Norm::max ? relative : relative_rms; }
};

struct Comparison {
  std::vector<Difference> columns;
  std::size_t times = 0;                ///< Compared.
  std::size_t interpolated = 0;         ///< Of these, times at which the other one has no row.
  std::vector<std::string> linear;      ///< Columns that are interpolated by straight lines there.
  std::string at;                       ///< The file whose times these are.
  double shift = 0.0;                   ///< By how much A is later than B [s], in the measure's bounds.
  std::vector<std::string> uncompared;  ///< Sentences: columns and times that only one of them has.
};

/// Compares the columns that both have, or those named. They are compared at the times of the one that has
/// fewer rows, where both cover the time. Where the other has no row at such a time it is interpolated: by
/// cubic Hermite polynomials where it has a column der(NAME) (record.derivatives), else by straight lines,
/// which is told. Empty cells are left out. Of a time that stands twice (a jump), the first row is compared
/// with the first and the last with the last. With a shift in the measure, A is moved in time as a whole to
/// where the sum of the squared relative rms is least. Shifts at which less than half as many times are
/// compared as at the best do not count. Columns (if none are named) and times that only one has are told
/// in `uncompared`. Throws Error for a column that is not there, no column or no time in common, a
/// table without rows, and a measure that is no number.
Comparison compare(const TimeTable& a, const TimeTable& b, const std::vector<std::string>& columns = {},
                   const Measure& measure = {});

/// A line for each column and one on how they were compared.
std::string text(const Comparison& comparison);

/// "fast.x1 differs by 0.3 (2.7 % of its largest magnitude) at t = 12.5 s, tolerance 1 %" for the worst
/// column beyond its tolerance; empty if all are within.
std::string beyond(const Comparison& comparison, double tolerance, Norm norm = Norm::max);
std::string text(const Difference& difference, double tolerance, Norm norm = Norm::max);

}  // namespace tandem::scenario
