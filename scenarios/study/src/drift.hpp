// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "followed.hpp"
#include "tandem/scenario/traces.hpp"
#include "tandem/study/study.hpp"

namespace tandem::study {

/// The outputs that a drift is made of, the one at whose rows it is taken first.
std::vector<std::string> outputs_of_drift(const Metric& metric);

/// The departure of an expression from its start, over time.
class Drift {
 public:
  /// columns: those of the row. times: at which it is taken; they must outlive it. Throws Error for what is
  /// wrong with the expression.
  Drift(const Metric& metric, const scenario::Traces& traces, const FileValues& columns,
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

/// A norm of it.
double drift(const Metric& metric, const scenario::Traces& traces, const FileValues& columns);

}  // namespace tandem::study
