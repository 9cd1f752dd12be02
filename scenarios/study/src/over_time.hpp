// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "followed.hpp"
#include "tandem/study/study.hpp"

namespace tandem::study {

/// Finds the names of outputs in a signal or a drift whose formula was read: OUTPUT of the run, or
/// OUTPUT.REFERENCE.
void find_outputs(Metric& metric, const std::vector<Reference>& references);

/// Results by what an expression calls an output. Throws Error(numerical) for a reference that failed.
using TableOf = std::function<const text::TimeTable&(const std::string& name)>;

/// The expression of a metric over time; of a drift its departure from its start.
class OverTime {
 public:
  /// columns: those of the row. times: at which it is taken; they must outlive it, as the tables must. Throws
  /// Error for what is wrong with the expression.
  OverTime(const Metric& metric, const TableOf& table_of, const FileValues& columns,
           const std::vector<double>& times);

  /// At a row of the times, in rising order; nothing where an output is not known.
  std::optional<double> at(std::size_t row);
  /// By what it is divided: the magnitude at the start, if the metric is relative to it, else 1.
  double divisor() const;

 private:
  const Metric& metric_;
  text::Expression expression_;
  Followed followed_;
  std::optional<double> start_;
};

/// A norm of it, at the rows of the output that stands first in it.
double size_over_time(const Metric& metric, const TableOf& table_of, const FileValues& columns);

}  // namespace tandem::study
