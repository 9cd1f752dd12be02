// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "tandem/scenario/comparison.hpp"
#include "tandem/scenario/traces.hpp"
#include "tandem/study/study.hpp"

namespace tandem::study {

/// Outputs over time by the names that they have in the study.
using OutputTables = std::map<std::string, text::TimeTable>;

/// Whether all that an expression asks for is there; and its value. Throws Error with its place.
bool is_known(const Formula& formula, const FileValues& values);
double value_of(const Formula& formula, const FileValues& values);

/// Those of its metrics that a table needs: what it has, and what its formulas and verdicts are made of, in
/// the order of the study.
std::vector<const Metric*> needed_metrics(const Study& study, const Table& table);
/// The outputs that a run has to give for them.
std::vector<std::string> judged_outputs(const std::vector<const Metric*>& metrics, const Table& table);
/// Of these, those that a reference has to give.
std::vector<std::string> referred_outputs(const std::vector<const Metric*>& metrics,
                                          const std::string& reference);

/// A norm of a difference in the unit of the output, unless the metric has another.
struct Judged {
  double value, shift;
};

/// Differences of outputs of a run from references. What metrics with the same output, window and reference
/// are made of is compared once.
class Differences {
 public:
  Judged of(const Metric& metric, const text::TimeTable& run, const text::TimeTable& reference,
            const std::string& unit);

 private:
  using Key = std::tuple<const text::TimeTable*, const text::TimeTable*, double, double, double>;
  std::map<Key, scenario::Comparison> compared_;
};

/// A norm of an output itself.
double size_of(const Metric& metric, const text::TimeTable& run, const std::string& unit);

/// "1" of a fraction, else that of the metric or of the output.
std::string unit_of(const Metric& metric, const std::string& of_output);

}  // namespace tandem::study
