// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "tandem/coordinator/coordinator.hpp"
#include "tandem/text/time_table.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem::study {

/// A number that only code can tell of a run, which it observes from its first samples on.
class CodedMetric : public Observer {
 public:
  /// After the run. reference: what the metric names as `against`, with the column that its parameter `output` is; null
  /// without it. Nothing where it has no meaning; `note` then says why.
  virtual std::optional<double> value(std::string& note, const text::TimeTable* reference) const = 0;
};

/// By the NAME of { builtin = NAME }: what makes one for a run that is not begun. Its parameters are asked
/// for by name and type (`with`); what is not asked for is refused.
using CodedMetrics =
    std::map<std::string, std::function<std::unique_ptr<CodedMetric>(
                              const Coordinator& run, const TimeSpan& span, Parameters& parameters)>>;

}  // namespace tandem::study
