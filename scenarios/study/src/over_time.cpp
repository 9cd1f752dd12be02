// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "over_time.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "norm_of.hpp"

namespace tandem::study {
namespace {

const std::string slope_of = "der.";

/// An expression with "der.X" in place of "der(X)".
std::string with_slopes(std::string of) {
  for (std::size_t at = 0; (at = of.find("der(", at)) != std::string::npos;) {
    const auto end = of.find(')', at);
    if (end == std::string::npos) break;
    const std::string output = of.substr(at + slope_of.size(), end - at - slope_of.size());
    of.replace(at, end + 1 - at, slope_of + output);
  }
  return of;
}

/// The output of "X" or "der.X".
std::string output_of(const std::string& name) {
  return name.starts_with(slope_of) ? name.substr(slope_of.size()) : name;
}

bool is_slope(const std::string& name) { return name.starts_with(slope_of); }

/// The numbers of its expression that are outputs.
std::vector<std::string> followed_by(const text::Expression& expression, const FileValues& columns) {
  for (const std::string& name : expression.numbers())
    if (const auto word = columns.find(name); word != columns.end())
      throw Error(ErrorCode::invalid_argument, "the expression has " + name + ", which is the word " +
                                                   text::shown(word->second) + "; allowed is a number");
  if (!expression.words().empty())
    throw Error(ErrorCode::invalid_argument, "the expression '" + expression.text() +
                                                 "' compares words; allowed is one of outputs and numbers");
  return expression.numbers();
}

/// Of a name that ends with a reference's.
std::optional<Metric::Referred> referred(const std::string& name, const std::vector<Reference>& references) {
  const auto dot = name.rfind('.');
  if (dot == std::string::npos || name.find('.') == dot) return {};
  const auto it = std::find_if(references.begin(), references.end(),
                               [&](const Reference& one) { return one.name == name.substr(dot + 1); });
  if (it == references.end()) return {};
  return Metric::Referred{name, name.substr(0, dot), it->name};
}

}  // namespace

void find_outputs(Metric& metric, const std::vector<Reference>& references) {
  std::set<std::string> names;
  for (const std::string& name :
       located(metric.formula->place, [&] { return text::names_in(with_slopes(metric.formula->text)); }))
    names.insert(output_of(name));
  for (const std::string& name : names)
    if (auto of_reference = referred(name, references))
      metric.referred.push_back(*std::move(of_reference));
    else
      metric.outputs.push_back(name);
}

OverTime::OverTime(const Metric& metric, const TableOf& table_of, const FileValues& columns,
                   const std::vector<double>& times)
    : metric_(metric), expression_(with_slopes(metric.formula->text), columns), followed_(times) {
  for (const std::string& name : followed_by(expression_, columns)) {
    const auto it = std::find_if(metric.referred.begin(), metric.referred.end(),
                                 [&](const auto& one) { return one.name == output_of(name); });
    followed_.add(table_of(output_of(name)), it == metric.referred.end() ? output_of(name) : it->output,
                  is_slope(name));
  }
}

std::optional<double> OverTime::at(std::size_t row) {
  if (!followed_.move_to(row)) return {};
  const double value = expression_.at(followed_.values());
  if (metric_.kind == Metric::Kind::signal) return value;
  if (!start_) start_ = value;
  return value - *start_;
}

double OverTime::divisor() const {
  return metric_.relative == Metric::Relative::start ? std::abs(start_.value_or(0.0)) : 1.0;
}

double size_over_time(const Metric& metric, const TableOf& table_of, const FileValues& columns) {
  return located(metric.formula->place, [&] {
    const text::Expression expression(with_slopes(metric.formula->text), columns);
    const auto& times = table_of(output_of(followed_by(expression, columns)[0])).times;
    OverTime course(metric, table_of, columns, times);
    NormOf norm;
    for (std::size_t row = 0; row < times.size(); ++row)
      if (const auto value = course.at(row); value && is_in_window(metric, times[row])) norm.add(*value);
    if (norm.empty() || !(course.divisor() > 0.0))
      throw Error(
          ErrorCode::invalid_argument,
          "metrics." + metric.name + ": the expression " +
              (norm.empty() ? "has no time that counts" : "is 0 at the start, and is relative to it"));
    return norm.of(metric.norm) / course.divisor();
  });
}

}  // namespace tandem::study
