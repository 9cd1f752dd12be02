// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "charts/two_mass_data.hpp"

namespace tandem::charts {

/// No scheme with a larger Result::error() is called the best.
inline constexpr double best_limit = 0.1;
/// One scheme stands for a range of ratios where its error is at most so many times the smallest one, or
/// small anyway.
inline constexpr double good_as_best = 2.0;
inline constexpr double small_anyway = 0.01;

/// Consecutive frequency ratios of the table with the same best scheme, or with none.
struct BestRange {
  double first_ratio = 0.0, last_ratio = 0.0;
  std::optional<Scheme> scheme;
  double smallest_error = 0.0, largest_error = 0.0;  ///< Result::error() of the scheme over the range
};

/// Covers the ratios, from the lowest up, with as few ranges as the rules above allow; among schemes that
/// reach as far the one with the smallest largest error is taken. Only results whose scheme `takes_part`
/// count.
std::vector<BestRange> best_ranges(const std::vector<Result>& results,
                                   const std::function<bool(const Scheme&)>& takes_part);

/// The scheme with the smallest error at one ratio, if any is within best_limit.
const Result* best_at(const std::vector<Result>& results, double frequency_ratio);

/// The ranges as lines of a table: ratios, scheme, errors in percent.
std::string table_of(const std::vector<BestRange>& ranges);

/// All schemes, and, for couplings that matched hold can't serve, all but it; with the rule.
std::string short_table(const std::vector<Result>& sweep);

}  // namespace tandem::charts
