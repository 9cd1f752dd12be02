// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "best_shift.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/scenario/courses.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::scenario {
namespace {

[[noreturn]] void fail(const std::string& sentence) { throw Error(ErrorCode::invalid_argument, sentence); }

bool is_derivative(const std::string& name) { return name.starts_with("der(") && name.ends_with(")"); }

/// Derivatives help to interpolate.
std::vector<std::string> common(const TimeTable& a, const TimeTable& b) {
  const Courses in_b(b);
  std::vector<std::string> names;
  for (const std::string& name : a.names)
    if (in_b.has(name) && !is_derivative(name)) names.push_back(name);
  if (names.empty())
    fail("no column is in both: " + a.file.string() + " has " + listed(a.names) + ", " + b.file.string() +
         " has " + listed(b.names));
  return names;
}

void check(const TimeTable& a, const TimeTable& b, const Measure& measure) {
  for (const TimeTable* table : {&a, &b})
    if (table->times.empty()) fail(table->file.string() + " has no rows to compare");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(measure.from <= measure.to) || measure.from == infinity || measure.to == -infinity)
    fail(fmt::format(
        "times from {} to {} s are to be compared; allowed are numbers, the second not before the first",
        measure.from, measure.to));
  if (!(measure.shift >= 0.0) || std::isinf(measure.shift))
    fail(fmt::format("a shift of {} s; allowed is a number from 0", measure.shift));
}

/// Whether a time of B counts.
bool counts(double t, const Measure& measure) {
  const TimeTolerance tolerance(t);
  return !tolerance.before(t, measure.from) && !tolerance.before(measure.to, t);
}

/// At the times that count, which are those of B: `later` is by how much the table's are later.
double largest(const TimeTable& table, const Course& course, const Measure& measure, double later) {
  double most = 0.0;
  const std::vector<double>& column = table.columns[course.values];
  for (std::size_t row = 0; row < column.size(); ++row)
    if (counts(table.times[row] - later, measure) && std::isfinite(column[row]))
      most = std::max(most, std::abs(column[row]));
  return most;
}

double fraction_of(double difference, double of) { return of > 0.0 ? difference / of : 0.0; }

/// Sums over the compared times of a column. The squares of small and large values are numbers, too.
struct Squares {
  long double difference = 0.0, a = 0.0, b = 0.0;
};

void note(Difference& d, Squares& sums, double time, double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return;
  const auto square = [](long double x) { return x * x; };
  sums.difference += square(a - b), sums.a += square(a), sums.b += square(b);
  d.end = std::abs(a - b);
  if (d.compared++ > 0 && !(std::abs(a - b) > d.absolute)) return;
  d.time = time, d.a = a, d.b = b, d.absolute = std::abs(a - b);
}

/// Two tables side by side at the times of the one with fewer rows, A being `shift` later than B.
class SideBySide {
 public:
  SideBySide(const TimeTable& a, const TimeTable& b, const Measure& measure, double shift)
      : a_(a), b_(b), measure_(measure), shift_(shift), of_a_(a), of_b_(b) {
    const double begin = std::max(a.times.front(), b.times.front()),
                 end = std::min(a.times.back(), b.times.back());
    at_a_ = of_a_.count_between(begin, end) < of_b_.count_between(begin, end);
  }

  void add(const std::string& column) {
    columns_.emplace_back(of_a_.course(column), of_b_.course(column));
    result_.columns.push_back({column});
  }

  /// Of no time, or no value of a column, where there is none in common.
  /// scaled: with the peaks of columns.
  Comparison compared(bool scaled) {
    const TimeTable& coarse = at_a_ ? a_ : b_;
    result_.at = coarse.file.string();
    result_.shift = shift_;
    sums_.assign(columns_.size(), {});
    for (std::size_t row = 0; row < coarse.times.size(); ++row)
      at(coarse.times[row], row > 0 && coarse.times[row] == coarse.times[row - 1]);
    for (std::size_t k = 0; k < columns_.size(); ++k)
      if (result_.columns[k].compared > 0) scale(k, scaled);
    return std::move(result_);
  }

 private:
  void at(double t, bool again) {
    const double t_a = at_a_ ? t : t + shift_, t_b = at_a_ ? t - shift_ : t;
    if (!counts(t_b, measure_) || !of_a_.covers(t_a) || !of_b_.covers(t_b)) return;
    of_a_.move_to(t_a, again);
    of_b_.move_to(t_b, again);
    ++result_.times;
    result_.interpolated += !of_a_.exact() || !of_b_.exact();
    for (std::size_t k = 0; k < columns_.size(); ++k)
      if (const auto& [a, b] = columns_[k]; measure_.lines || (is_known(of_a_, a) && is_known(of_b_, b)))
        note(result_.columns[k], sums_[k], t_a, of_a_.value(a), of_b_.value(b));
  }

  static bool is_known(const Courses& courses, const Course& course) {
    return courses.exact() || course.derivatives;
  }

  void scale(std::size_t k, bool by_peak) {
    Difference& d = result_.columns[k];
    const auto& [a, b] = columns_[k];
    const double of = static_cast<double>(d.compared);
    if (by_peak) {
      const double peak = largest(b_, b, measure_, 0.0);
      d.peak = peak > 0.0 ? peak : largest(a_, a, measure_, shift_);
      d.relative = fraction_of(d.absolute, d.peak);
    }
    d.rms = static_cast<double>(std::sqrt(sums_[k].difference / of));
    d.rms_of = static_cast<double>(std::sqrt((sums_[k].b > 0.0L ? sums_[k].b : sums_[k].a) / of));
    d.relative_rms = fraction_of(d.rms, d.rms_of);
    const bool smooth = (at_a_ ? b : a).derivatives.has_value();
    if (measure_.lines && result_.interpolated > 0 && !smooth) result_.linear.push_back(d.column);
  }

  const TimeTable &a_, &b_;
  const Measure& measure_;
  double shift_;
  Courses of_a_, of_b_;
  bool at_a_;
  std::vector<std::pair<Course, Course>> columns_;
  std::vector<Squares> sums_;
  Comparison result_;
};

Comparison compare_shifted(const TimeTable& a, const TimeTable& b, const std::vector<std::string>& names,
                           const Measure& measure, double shift, bool scaled) {
  SideBySide both(a, b, measure, shift);
  for (const std::string& name : names) both.add(name);
  return both.compared(scaled);
}

std::string window(const Measure& measure, double shift) {
  const bool all = std::isinf(measure.from) && std::isinf(measure.to);
  std::string text = all ? "" : fmt::format("; from {} to {} s count", measure.from, measure.to);
  if (shift != 0.0) text += fmt::format("; the first is moved by {} s", -shift);
  return text;
}

void refuse_nothing(const Comparison& comparison, const TimeTable& a, const TimeTable& b,
                    const Measure& measure) {
  if (comparison.times == 0)
    fail(fmt::format("no time is in both: {} covers {} to {} s, {} covers {} to {} s{}", a.file.string(),
                     a.times.front(), a.times.back(), b.file.string(), b.times.front(), b.times.back(),
                     window(measure, comparison.shift)));
  for (const Difference& d : comparison.columns)
    if (d.compared == 0) fail("column " + d.column + " has no time at which both have a value");
}

void tell_uncompared(const TimeTable& a, const TimeTable& b, const std::vector<std::string>& compared,
                     Comparison& to) {
  const Courses of_a(a), of_b(b);
  if (!of_b.covers(a.times.front()) || !of_b.covers(a.times.back()) || !of_a.covers(b.times.front()) ||
      !of_a.covers(b.times.back()))
    to.uncompared.push_back(fmt::format("{} covers {} to {} s, {} covers {} to {} s", a.file.string(),
                                        a.times.front(), a.times.back(), b.file.string(), b.times.front(),
                                        b.times.back()));
  if (compared.empty()) return;
  const std::unordered_set<std::string_view> those(compared.begin(), compared.end());
  for (const TimeTable* table : {&a, &b})
    for (const std::string& name : table->names)
      if (!those.contains(name) && !is_derivative(name))
        to.uncompared.push_back("column " + name + " is in " + table->file.string() + " only");
}

}  // namespace

Comparison compare(const TimeTable& a, const TimeTable& b, const std::vector<std::string>& columns,
                   const Measure& measure) {
  check(a, b, measure);
  const auto names = columns.empty() ? common(a, b) : columns;
  const auto shifted = [&](double shift) { return compare_shifted(a, b, names, measure, shift, false); };
  const double shift = measure.shift > 0.0 ? best_shift(a, b, names, measure.shift, shifted) : 0.0;
  Comparison comparison = compare_shifted(a, b, names, measure, shift, true);
  refuse_nothing(comparison, a, b, measure);
  tell_uncompared(a, b, columns.empty() ? names : std::vector<std::string>(), comparison);
  return comparison;
}

}  // namespace tandem::scenario
