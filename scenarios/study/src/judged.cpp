// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "judged.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "tandem/coordinator/units.hpp"
#include "tandem/scenario/courses.hpp"

namespace tandem::study {
namespace {

using scenario::Difference;
using text::Expression;
using text::TimeTable;

void add_names(const Formula& formula, std::set<std::string>& to) {
  const auto names = text::names_in(formula.text);
  to.insert(names.begin(), names.end());
}

const std::string slope_of = "der.";

/// A drift with "der.X" in place of "der(X)".
std::string with_slopes(std::string drift) {
  for (std::size_t at = 0; (at = drift.find("der(", at)) != std::string::npos;) {
    const auto end = drift.find(')', at);
    if (end == std::string::npos) break;
    const std::string output = drift.substr(at + slope_of.size(), end - at - slope_of.size());
    drift.replace(at, end + 1 - at, slope_of + output);
  }
  return drift;
}

/// The output of "X" or "der.X".
std::string output_of(const std::string& name) {
  return name.starts_with(slope_of) ? name.substr(slope_of.size()) : name;
}

double factor(const Metric& metric, const std::string& unit) {
  if (metric.unit.empty()) return 1.0;
  const auto conversion = convert_unit(unit, metric.unit);
  if (!conversion || (metric.against.empty() && conversion->shift != 0.0))
    refuse(metric.place, "metrics." + metric.name + ".unit is '" + metric.unit + "', and " + metric.of +
                             " is in '" + unit + "'; allowed is a unit of the same quantity");
  return conversion->factor;
}

double size(const Metric& metric, const Difference& d) {
  return metric.norm == Metric::Norm::max ? d.absolute : metric.norm == Metric::Norm::rms ? d.rms : d.end;
}

double divisor(const Metric& metric, const Difference& d) {
  const double by = metric.relative == Metric::Relative::peak  ? d.peak
                    : metric.relative == Metric::Relative::rms ? d.rms_of
                                                               : 1.0;
  return by > 0.0 ? by : 1.0;  // both are 0 all the time
}

bool is_in_window(const Metric& metric, double t) { return t >= metric.window.from && t <= metric.window.to; }

/// A sum of squares, a largest and a last one of values over time.
class NormOf {
 public:
  void add(double value) {
    squares_ += value * value;
    largest_ = std::max(largest_, std::abs(value));
    last_ = std::abs(value);
    ++count_;
  }
  double of(Metric::Norm norm) const {
    return norm == Metric::Norm::max   ? largest_
           : norm == Metric::Norm::rms ? std::sqrt(squares_ / static_cast<double>(count_))
                                       : last_;
  }
  bool empty() const { return count_ == 0; }

 private:
  double squares_ = 0.0, largest_ = 0.0, last_ = 0.0;
  std::size_t count_ = 0;
};

/// The numbers of an expression at the rows of the output that stands first in it, and of what else it has
/// there.
class Followed {
 public:
  Followed(const Expression& expression, const scenario::Traces& traces, const FileValues& columns) {
    for (const std::string& name : expression.numbers()) {
      if (const auto word = columns.find(name); word != columns.end())
        throw Error(ErrorCode::invalid_argument, "the drift has " + name + ", which is the word " +
                                                     text::shown(word->second) + "; allowed is a number");
      follow(name, traces.of(output_of(name)));
    }
    if (!first_ || !expression.words().empty())
      throw Error(ErrorCode::invalid_argument, "the drift '" + expression.text() + "' " +
                                                   (first_ ? "compares words" : "names no output") +
                                                   "; allowed is an expression of outputs and numbers");
  }

  const std::vector<double>& times() const { return first_->times; }
  /// False: one of them is not known there.
  bool move_to(std::size_t row) {
    const double t = first_->times[row];
    const bool again = row > 0 && first_->times[row - 1] == t;
    for (std::size_t k = 0; k < followers_.size(); ++k) {
      Follower& one = followers_[k];
      if (one.rows) {
        values_[k] = (*one.rows)[row];
        continue;
      }
      if (!one.courses.covers(t)) return false;
      one.courses.move_to(t, again);
      if (!one.courses.exact() && !one.course.derivatives) return false;
      values_[k] = one.slope ? one.courses.slope(one.course) : one.courses.value(one.course);
    }
    return true;
  }
  const std::vector<double>& values() const { return values_; }

 private:
  void follow(const std::string& name, const TimeTable& table) {
    if (!first_) first_ = &table;
    scenario::Courses courses(table);
    const auto course = courses.course(output_of(name));
    const bool slope = name.starts_with(slope_of);
    if (slope && !course.derivatives)
      throw Error(ErrorCode::invalid_argument,
                  output_of(name) + " gives no derivative; allowed is der(X) of an output that does");
    const auto& rows = table.columns[slope ? *course.derivatives : course.values];
    followers_.push_back({std::move(courses), course, slope, table.times == first_->times ? &rows : nullptr});
    values_.push_back(0.0);
  }

  struct Follower {
    scenario::Courses courses;
    scenario::Course course;
    bool slope;
    const std::vector<double>* rows;  ///< where it has the times of the first
  };
  const TimeTable* first_ = nullptr;
  std::vector<Follower> followers_;
  std::vector<double> values_;
};

}  // namespace

std::vector<const Metric*> needed_metrics(const Study& study, const Table& table) {
  std::set<std::string> names(table.metrics.begin(), table.metrics.end());
  for (const auto& when : {study.lost, study.unstable})
    if (when) add_names(*when, names);
  std::vector<const Metric*> needed;
  for (auto metric = study.metrics.rbegin(); metric != study.metrics.rend(); ++metric) {
    const auto own = study.names_of(*metric);
    if (std::none_of(own.begin(), own.end(), [&](const std::string& name) { return names.contains(name); }))
      continue;
    needed.insert(needed.begin(), &*metric);
    if (metric->kind == Metric::Kind::formula) add_names(*metric->formula, names);
  }
  return needed;
}

std::vector<std::string> judged_outputs(const std::vector<const Metric*>& metrics, const Table& table) {
  std::set<std::string> outputs;
  for (const Metric* metric : metrics) {
    if (metric->kind == Metric::Kind::output) outputs.insert(metric->of);
    if (metric->kind != Metric::Kind::drift) continue;
    std::set<std::string> names;
    add_names({with_slopes(metric->formula->text), {}}, names);
    for (const std::string& name : names) outputs.insert(output_of(name));
  }
  for (const std::string& column : table.columns) outputs.erase(column);
  return {outputs.begin(), outputs.end()};
}

std::vector<std::string> referred_outputs(const std::vector<const Metric*>& metrics,
                                          const std::string& reference) {
  std::set<std::string> outputs;
  for (const Metric* metric : metrics)
    if (metric->kind == Metric::Kind::output && metric->against == reference) outputs.insert(metric->of);
  return {outputs.begin(), outputs.end()};
}

Judged Differences::of(const Metric& metric, const TimeTable& run, const TimeTable& reference,
                       const std::string& unit) {
  return located(metric.place, [&] {
    const auto& [from, to, shift] = std::tie(metric.window.from, metric.window.to, metric.window.shift);
    scenario::Comparison& one = compared_[{&run, &reference, from, to, shift}];
    if (one.columns.empty()) one = scenario::compare(run, reference, {metric.of}, metric.window);
    const Difference& d = one.columns[0];
    return Judged{size(metric, d) / divisor(metric, d) * factor(metric, unit), one.shift};
  });
}

double size_of(const Metric& metric, const TimeTable& run, const std::string& unit) {
  return located(metric.place, [&] {
    NormOf own;
    for (std::size_t row = 0; row < run.times.size(); ++row)
      if (is_in_window(metric, run.times[row])) own.add(run.columns[0][row]);
    if (own.empty())
      throw Error(ErrorCode::invalid_argument,
                  "metrics." + metric.name + ": " + metric.of + " has no time that counts");
    const double by = metric.relative == Metric::Relative::peak  ? own.of(Metric::Norm::max)
                      : metric.relative == Metric::Relative::rms ? own.of(Metric::Norm::rms)
                                                                 : 1.0;
    return own.of(metric.norm) / (by > 0.0 ? by : 1.0) * factor(metric, unit);
  });
}

double drift(const Metric& metric, const scenario::Traces& traces, const FileValues& columns) {
  return located(metric.formula->place, [&] {
    Expression expression(with_slopes(metric.formula->text), columns);
    Followed followed(expression, traces, columns);
    NormOf departure;
    std::optional<double> start;
    for (std::size_t row = 0; row < followed.times().size(); ++row) {
      if (!followed.move_to(row)) continue;
      const double value = expression.at(followed.values()), t = followed.times()[row];
      if (!start) start = value;
      if (is_in_window(metric, t)) departure.add(value - *start);
    }
    const double by = metric.relative == Metric::Relative::start ? std::abs(start.value_or(0.0)) : 1.0;
    if (departure.empty() || !(by > 0.0))
      throw Error(
          ErrorCode::invalid_argument,
          "metrics." + metric.name + ": the drift " +
              (departure.empty() ? "has no time that counts" : "is 0 at the start, and is relative to it"));
    return departure.of(metric.norm) / by;
  });
}

std::string unit_of(const Metric& metric, const std::string& of_output) {
  const bool counted = metric.kind == Metric::Kind::exchanges || metric.kind == Metric::Kind::steps;
  if (counted || metric.relative != Metric::Relative::no) return "1";
  return metric.kind == Metric::Kind::output ? metric.unit.empty() ? of_output : metric.unit : "";
}

}  // namespace tandem::study
