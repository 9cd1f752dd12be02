// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "scenario/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::scenario {
namespace {

[[noreturn]] void fail(const std::string& sentence) { throw Error(ErrorCode::invalid_argument, sentence); }

/// Columns of a table by name.
class Columns {
 public:
  explicit Columns(const TimeTable& table) : table_(table) {
    for (std::size_t k = 0; k < table.names.size(); ++k) index_.emplace(table.names[k], k);
  }
  bool has(const std::string& name) const { return index_.contains(name); }
  std::size_t index_of(const std::string& name) const {
    const auto it = index_.find(name);
    if (it == index_.end()) fail(table_.file.string() + ": " + unknown("column", name, table_.names));
    return it->second;
  }

 private:
  const TimeTable& table_;
  std::unordered_map<std::string_view, std::size_t> index_;
};

std::vector<std::string> common(const TimeTable& a, const TimeTable& b) {
  const Columns in_b(b);
  std::vector<std::string> names;
  for (const std::string& name : a.names)
    if (in_b.has(name)) names.push_back(name);
  if (names.empty())
    fail("no column is in both: " + a.file.string() + " has " + listed(a.names) + ", " + b.file.string() +
         " has " + listed(b.names));
  return names;
}

/// Finds for rising times the row of a table, or the two rows around it.
class Rows {
 public:
  explicit Rows(const TimeTable& table) : table_(table), tolerance_(table.times.front()) {}

  bool covers(double t) const {
    return !tolerance_.before(t, table_.times.front()) && !tolerance_.before(table_.times.back(), t);
  }
  std::size_t count_between(double begin, double end) const {
    return static_cast<std::size_t>(std::count_if(table_.times.begin(), table_.times.end(), [&](double t) {
      return !tolerance_.before(t, begin) && !tolerance_.before(end, t);
    }));
  }
  /// again: the second row of this time is wanted, if there is one.
  void move_to(double t, bool again) {
    while (row_ + 1 < table_.times.size() && tolerance_.before(table_.times[row_], t)) ++row_;
    while (again && row_ + 1 < table_.times.size() && !tolerance_.before(t, table_.times[row_ + 1])) ++row_;
    time_ = t;
  }
  bool exact() const { return row_ == 0 || !tolerance_.before(time_, table_.times[row_]); }
  double value(std::size_t column) const {
    const std::vector<double>& y = table_.columns[column];
    if (exact()) return y[row_];
    const double begin = table_.times[row_ - 1], end = table_.times[row_];
    return y[row_ - 1] + (time_ - begin) / (end - begin) * (y[row_] - y[row_ - 1]);
  }

 private:
  const TimeTable& table_;
  TimeTolerance tolerance_;
  std::size_t row_ = 0;
  double time_ = 0.0;
};

double largest(const std::vector<double>& column) {
  double most = 0.0;
  for (const double value : column)
    if (std::isfinite(value)) most = std::max(most, std::abs(value));
  return most;
}

void note(Difference& d, double time, double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return;
  if (d.compared++ > 0 && !(std::abs(a - b) > d.absolute)) return;
  d.time = time, d.a = a, d.b = b, d.absolute = std::abs(a - b);
}

/// Two tables side by side at the times of the one with fewer rows.
class SideBySide {
 public:
  SideBySide(const TimeTable& a, const TimeTable& b)
      : a_(a), b_(b), columns_a_(a), columns_b_(b), rows_a_(a), rows_b_(b) {
    const double begin = std::max(a.times.front(), b.times.front()),
                 end = std::min(a.times.back(), b.times.back());
    coarse_ = rows_a_.count_between(begin, end) < rows_b_.count_between(begin, end) ? &a : &b;
  }

  void add(const std::string& column) {
    index_.emplace_back(columns_a_.index_of(column), columns_b_.index_of(column));
    result_.columns.push_back({column});
  }

  Comparison compared() {
    result_.at = coarse_->file.string();
    const std::vector<double>& times = coarse_->times;
    for (std::size_t row = 0; row < times.size(); ++row)
      if (rows_a_.covers(times[row]) && rows_b_.covers(times[row]))
        at(times[row], row > 0 && times[row] == times[row - 1]);
    if (result_.times == 0)
      fail(fmt::format("no time is in both: {} covers {} to {} s, {} covers {} to {} s", a_.file.string(),
                       a_.times.front(), a_.times.back(), b_.file.string(), b_.times.front(),
                       b_.times.back()));
    for (std::size_t k = 0; k < index_.size(); ++k) scale(k);
    if (!rows_b_.covers(a_.times.front()) || !rows_b_.covers(a_.times.back()) ||
        !rows_a_.covers(b_.times.front()) || !rows_a_.covers(b_.times.back()))
      result_.uncompared.push_back(fmt::format("{} covers {} to {} s, {} covers {} to {} s", a_.file.string(),
                                               a_.times.front(), a_.times.back(), b_.file.string(),
                                               b_.times.front(), b_.times.back()));
    return std::move(result_);
  }

 private:
  void at(double t, bool again) {
    rows_a_.move_to(t, again);
    rows_b_.move_to(t, again);
    ++result_.times;
    result_.interpolated += !rows_a_.exact() || !rows_b_.exact();
    for (std::size_t k = 0; k < index_.size(); ++k)
      note(result_.columns[k], t, rows_a_.value(index_[k].first), rows_b_.value(index_[k].second));
  }

  void scale(std::size_t k) {
    Difference& d = result_.columns[k];
    if (d.compared == 0) fail("column " + d.column + " has no time at which both have a value");
    const double of_b = largest(b_.columns[index_[k].second]);
    const double by = of_b > 0.0 ? of_b : largest(a_.columns[index_[k].first]);
    d.relative = by > 0.0 ? d.absolute / by : 0.0;
  }

  const TimeTable &a_, &b_;
  Columns columns_a_, columns_b_;
  Rows rows_a_, rows_b_;
  const TimeTable* coarse_;
  std::vector<std::pair<std::size_t, std::size_t>> index_;
  Comparison result_;
};

std::string percent(double fraction) { return fmt::format("{:.3g} %", 100.0 * fraction); }

}  // namespace

Comparison compare(const TimeTable& a, const TimeTable& b, const std::vector<std::string>& columns) {
  SideBySide both(a, b);
  const auto names = columns.empty() ? common(a, b) : columns;
  for (const std::string& name : names) both.add(name);
  Comparison comparison = both.compared();
  const std::unordered_set<std::string_view> compared(names.begin(), names.end());
  for (const TimeTable* table : {&a, &b})
    for (const std::string& name : table->names)
      if (columns.empty() && !compared.contains(name))
        comparison.uncompared.push_back("column " + name + " is in " + table->file.string() + " only");
  return comparison;
}

std::string text(const Comparison& comparison) {
  std::string lines =
      fmt::format("{:<24} {:>14} {:>12} {:>12}\n", "column", "largest diff.", "relative", "at time [s]");
  for (const Difference& d : comparison.columns)
    lines +=
        fmt::format("{:<24} {:>14.6g} {:>12} {:>12.6g}\n", d.column, d.absolute, percent(d.relative), d.time);
  lines += fmt::format(
      "compared at {} times of {}; at {} of them the other has no row and is interpolated linearly\n",
      comparison.times, comparison.at, comparison.interpolated);
  for (const std::string& sentence : comparison.uncompared) lines += sentence + '\n';
  return lines;
}

std::string text(const Difference& d, double tolerance) {
  return fmt::format(
      "{} differs by {:.6g} ({} of its largest magnitude) at t = {:.6g} s: {:.9g} and {:.9g}; tolerance {}",
      d.column, d.absolute, percent(d.relative), d.time, d.a, d.b, percent(tolerance));
}

std::string beyond(const Comparison& comparison, double tolerance) {
  const auto worst =
      std::max_element(comparison.columns.begin(), comparison.columns.end(),
                       [](const Difference& x, const Difference& y) { return x.relative < y.relative; });
  if (!(worst->relative <= tolerance)) return text(*worst, tolerance);
  return comparison.uncompared.empty() ? std::string() : "not the same: " + comparison.uncompared.front();
}

}  // namespace tandem::scenario
