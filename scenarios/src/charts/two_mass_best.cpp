// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/two_mass_best.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace tandem::charts {
namespace {

using AtRatio = std::vector<const Result*>;

const Result* smallest(const AtRatio& results) {
  const auto less = [](const Result* a, const Result* b) { return a->error() < b->error(); };
  const auto found = std::min_element(results.begin(), results.end(), less);
  return found != results.end() && (*found)->error() <= best_limit ? *found : nullptr;
}

/// The candidates at one ratio: as good as the best one, or nearly.
AtRatio candidates(const AtRatio& results) {
  const Result* best = smallest(results);
  if (best == nullptr) return {};
  const double limit = std::min(best_limit, std::max(small_anyway, good_as_best * best->error()));
  AtRatio good;
  for (const Result* r : results)
    if (r->error() <= limit) good.push_back(r);
  return good;
}

const Result* with_scheme(const AtRatio& results, const Scheme& scheme) {
  const auto found =
      std::find_if(results.begin(), results.end(), [&](const Result* r) { return r->scheme == scheme; });
  return found == results.end() ? nullptr : *found;
}

using Column = std::vector<AtRatio>;  // the candidates at each ratio, by rising ratio

/// The range of this scheme that begins at column `first`.
BestRange range_of(const Column& columns, std::size_t first, const Result& start, std::size_t& end) {
  BestRange range{start.frequency_ratio, start.frequency_ratio, start.scheme, start.error(), start.error()};
  for (end = first; end < columns.size(); ++end) {
    const Result* r = with_scheme(columns[end], start.scheme);
    if (r == nullptr) break;
    range.last_ratio = r->frequency_ratio;
    range.smallest_error = std::min(range.smallest_error, r->error());
    range.largest_error = std::max(range.largest_error, r->error());
  }
  return range;
}

/// The longest range that begins at column `first`, and the column after it.
BestRange longest_range(const Column& columns, std::size_t first, std::size_t& end) {
  BestRange longest;
  end = first;
  for (const Result* start : columns[first]) {
    std::size_t its_end = 0;
    const BestRange range = range_of(columns, first, *start, its_end);
    if (its_end < end || (its_end == end && range.largest_error >= longest.largest_error)) continue;
    longest = range;
    end = its_end;
  }
  return longest;
}

BestRange empty_range(const Column& columns, const std::vector<double>& ratios, std::size_t first,
                      std::size_t& end) {
  for (end = first; end < columns.size() && columns[end].empty();) ++end;
  return {ratios[first], ratios[end - 1], std::nullopt, 0.0, 0.0};
}

/// "1 to 5", or "1" if the two read the same.
std::string span_of(const char* format, double first, double last) {
  const std::string from = fmt::format(fmt::runtime(format), first);
  const std::string to = fmt::format(fmt::runtime(format), last);
  return from == to ? from : from + " to " + to;
}

}  // namespace

std::vector<BestRange> best_ranges(const std::vector<Result>& results,
                                   const std::function<bool(const Scheme&)>& takes_part) {
  std::map<double, AtRatio> by_ratio;
  for (const Result& r : results)
    if (takes_part(r.scheme)) by_ratio[r.frequency_ratio].push_back(&r);
  std::vector<double> ratios;
  Column columns;
  for (const auto& [ratio, at_ratio] : by_ratio) {
    ratios.push_back(ratio);
    columns.push_back(candidates(at_ratio));
  }
  std::vector<BestRange> ranges;
  for (std::size_t first = 0, end = 0; first < columns.size(); first = end)
    ranges.push_back(columns[first].empty() ? empty_range(columns, ratios, first, end)
                                            : longest_range(columns, first, end));
  return ranges;
}

const Result* best_at(const std::vector<Result>& results, double frequency_ratio) {
  AtRatio at_ratio;
  for (const Result& r : results)
    if (r.frequency_ratio == frequency_ratio) at_ratio.push_back(&r);
  return smallest(at_ratio);
}

std::string table_of(const std::vector<BestRange>& ranges) {
  std::string text = fmt::format("  {:16} {:40} {}\n", "frequency ratio", "best scheme", "error");
  for (const BestRange& r : ranges) {
    const std::string ratios = span_of("{:g}", r.first_ratio, r.last_ratio);
    if (r.scheme)
      text += fmt::format("  {:16} {:40} {} %\n", ratios, name_of(*r.scheme),
                          span_of("{:.2g}", 100.0 * r.smallest_error, 100.0 * r.largest_error));
    else
      text += fmt::format("  {:16} none\n", ratios);
  }
  return text;
}

std::string short_table(const std::vector<Result>& sweep) {
  const auto without_matched_hold = [](const Scheme& s) {
    return compared(s) && s.to_fast != "matched_hold";
  };
  return "All schemes\n" + table_of(best_ranges(sweep, compared)) +
         "Without matched hold, which serves couplings of displacements only\n" +
         table_of(best_ranges(sweep, without_matched_hold)) +
         fmt::format(
             "Error: the larger of position error and amplitude error of the fast mode. Best over a range: "
             "at "
             "most {:g} %\nor {:g} times the smallest error at each of its ratios; none above {:g} %.\n",
             100.0 * small_anyway, good_as_best, 100.0 * best_limit);
}

}  // namespace tandem::charts
