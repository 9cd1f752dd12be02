// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "drift.hpp"

#include <algorithm>
#include <cmath>

#include "norm_of.hpp"

namespace tandem::study {
namespace {

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

bool is_slope(const std::string& name) { return name.starts_with(slope_of); }

/// The numbers of its expression that are outputs.
std::vector<std::string> followed_by(const text::Expression& expression, const FileValues& columns) {
  for (const std::string& name : expression.numbers())
    if (const auto word = columns.find(name); word != columns.end())
      throw Error(ErrorCode::invalid_argument, "the drift has " + name + ", which is the word " +
                                                   text::shown(word->second) + "; allowed is a number");
  if (expression.numbers().empty() || !expression.words().empty())
    throw Error(ErrorCode::invalid_argument,
                "the drift '" + expression.text() + "' " +
                    (expression.numbers().empty() ? "names no output" : "compares words") +
                    "; allowed is an expression of outputs and numbers");
  return expression.numbers();
}

}  // namespace

std::vector<std::string> outputs_of_drift(const Metric& metric) {
  std::vector<std::string> outputs;
  for (const std::string& name : text::names_in(with_slopes(metric.formula->text)))
    if (const std::string output = output_of(name);
        std::find(outputs.begin(), outputs.end(), output) == outputs.end())
      outputs.push_back(output);
  return outputs;
}

Drift::Drift(const Metric& metric, const scenario::Traces& traces, const FileValues& columns,
             const std::vector<double>& times)
    : metric_(metric), expression_(with_slopes(metric.formula->text), columns), followed_(times) {
  for (const std::string& name : followed_by(expression_, columns))
    followed_.add(traces.of(output_of(name)), output_of(name), is_slope(name));
}

std::optional<double> Drift::at(std::size_t row) {
  if (!followed_.move_to(row)) return {};
  const double value = expression_.at(followed_.values());
  if (!start_) start_ = value;
  return value - *start_;
}

double Drift::divisor() const {
  return metric_.relative == Metric::Relative::start ? std::abs(start_.value_or(0.0)) : 1.0;
}

double drift(const Metric& metric, const scenario::Traces& traces, const FileValues& columns) {
  return located(metric.formula->place, [&] {
    const text::Expression expression(with_slopes(metric.formula->text), columns);
    const auto& times = traces.of(output_of(followed_by(expression, columns)[0])).times;
    Drift course(metric, traces, columns, times);
    NormOf departure;
    for (std::size_t row = 0; row < times.size(); ++row)
      if (const auto value = course.at(row); value && is_in_window(metric, times[row])) departure.add(*value);
    if (departure.empty() || !(course.divisor() > 0.0))
      throw Error(
          ErrorCode::invalid_argument,
          "metrics." + metric.name + ": the drift " +
              (departure.empty() ? "has no time that counts" : "is 0 at the start, and is relative to it"));
    return departure.of(metric.norm) / course.divisor();
  });
}

}  // namespace tandem::study
