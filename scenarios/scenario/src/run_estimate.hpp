// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tandem/coordinator/indicators.hpp"
#include "tandem/scenario/courses.hpp"
#include "tandem/scenario/scenario.hpp"

namespace tandem::scenario {

/// How far the judged output is off from what is expected of it, row by row of its subsystem.
class Estimate final : public Observer {
 public:
  /// expected: a column with the output's name, and may be der(NAME), from the start to the end of the run. indicators: of
  /// the same run, to be told before this; its windows count. All but `expected` must outlive it.
  Estimate(const Topology& topology, const JudgeEntry& judge, text::TimeTable expected,
           const Indicators& indicators);
  Estimate(const Estimate&) = delete;
  Estimate& operator=(const Estimate&) = delete;

  bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) override;

  /// "estimate(fast.x1)".
  const std::string& name() const { return name_; }
  /// Largest magnitude in each window of the indicators; negative: nothing was compared.
  const std::vector<double>& windows() const { return windows_; }
  nlohmann::ordered_json figures() const;
  const std::string& unit() const { return unit_; }
  /// "fast.x1 is off by 0.019 of its peak, of which 0.15 is allowed".
  std::string told() const;

  void save(ByteWriter& to) const;
  void resume(ByteReader& from);

 private:
  void add(double t, double off, double expected);

  const JudgeEntry& judge_;
  const Indicators& indicators_;
  text::TimeTable expected_;
  Courses courses_;
  Course course_;
  std::string name_, unit_;
  int subsystem_ = -1, output_ = 0;
  std::vector<double> windows_, ends_;
  std::size_t window_ = 0;
  double last_ = -std::numeric_limits<double>::infinity();                 ///< [s]
  double largest_ = 0.0, at_ = 0.0, peak_ = 0.0, off2_ = 0.0, of2_ = 0.0;  ///< of times that count
};

}  // namespace tandem::scenario
