// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/text/time_table.hpp"

namespace tandem::scenario {

using text::TimeTable;

/// Where one column of two results differs most.
struct Difference {
  std::string column;
  double time = 0.0;  ///< [s]
  double a = 0.0, b = 0.0;
  double absolute = 0.0;     ///< |a - b|
  double relative = 0.0;     ///< divided by the largest magnitude of the column in B (in A where that is 0)
  std::size_t compared = 0;  ///< values
};

struct Comparison {
  std::vector<Difference> columns;
  std::size_t times = 0;                ///< compared
  std::size_t interpolated = 0;         ///< of these, times at which the other one has no row
  std::string at;                       ///< the file whose times these are
  std::vector<std::string> uncompared;  ///< sentences: columns and times that only one of them has
};

/// Compares the columns that both have, or those named. They are compared at the times of the one that has
/// fewer rows where both cover the time; where the other has no row at such a time, it is interpolated
/// linearly. Empty cells are left out. Of a time that stands twice (a jump), the first row is compared with
/// the first and the last with the last. Throws Error for a column that is not there, no column or no time in
/// common; columns (if none are named) and times that only one has are told in `uncompared`.
Comparison compare(const TimeTable& a, const TimeTable& b, const std::vector<std::string>& columns = {});

/// A line for each column and one on how they were compared.
std::string text(const Comparison& comparison);

/// "fast.x1 differs by 0.3 (2.7 % of its largest magnitude) at t = 12.5 s, tolerance 1 %" for the worst
/// column beyond its tolerance; empty if all are within.
std::string beyond(const Comparison& comparison, double tolerance);
std::string text(const Difference& difference, double tolerance);

}  // namespace tandem::scenario
