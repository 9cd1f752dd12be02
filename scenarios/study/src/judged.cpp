// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "judged.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "norm_of.hpp"
#include "tandem/coordinator/units.hpp"

namespace tandem::study {
namespace {

using scenario::Difference;
using text::TimeTable;

void add_names(const Formula& formula, std::set<std::string>& to) {
  const auto names = text::names_in(formula.text);
  to.insert(names.begin(), names.end());
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

}  // namespace

bool is_known(const Formula& formula, const FileValues& values) {
  const auto names = text::names_in(formula.text);
  return std::all_of(names.begin(), names.end(), [&](const auto& name) { return values.contains(name); });
}

double value_of(const Formula& formula, const FileValues& values) {
  return located(formula.place, [&] { return text::evaluated(formula.text, values); });
}

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
    if (metric->kind == Metric::Kind::order) names.insert(metric->of);
  }
  return needed;
}

std::vector<std::string> judged_outputs(const std::vector<const Metric*>& metrics, const Table& table) {
  std::set<std::string> outputs;
  for (const Metric* metric : metrics) outputs.insert(metric->outputs.begin(), metric->outputs.end());
  for (const std::string& column : table.columns) outputs.erase(column);
  return {outputs.begin(), outputs.end()};
}

std::vector<std::string> referred_outputs(const std::vector<const Metric*>& metrics,
                                          const std::string& reference) {
  std::set<std::string> outputs;
  for (const Metric* metric : metrics)
    for (const Metric::Referred& one : metric->referred)
      if (one.reference == reference) outputs.insert(one.output);
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
    return own.of(metric.norm) * factor(metric, unit);
  });
}

std::string unit_of(const Metric& metric, const std::string& of_output) {
  if (metric.kind == Metric::Kind::seconds) return "s";
  const bool counted = metric.kind == Metric::Kind::exchanges || metric.kind == Metric::Kind::steps ||
                       metric.kind == Metric::Kind::order || metric.kind == Metric::Kind::stability ||
                       metric.is_time();
  if (counted || metric.relative != Metric::Relative::no) return "1";
  return metric.kind == Metric::Kind::output ? metric.unit.empty() ? of_output : metric.unit : "";
}

}  // namespace tandem::study
