// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "row_run.hpp"
#include "tandem/coordinator/observers.hpp"
#include "tandem/scenario/assembly.hpp"
#include "tandem/stability/modes.hpp"
#include "timing.hpp"

namespace tandem::study {

/// One run of a row, from its scenario to what it is judged by: begin, simulate, judge.
class RowRunner::OneRun {
 public:
  /// finer: its steps are half of what they are.
  OneRun(const RowRunner& all, const FileValues& row, std::vector<std::string> outputs, bool finer = false);
  /// False: it is refused.
  bool begin();
  /// False: `going` said no.
  bool simulate(const std::function<bool()>& going);
  void judge(const std::function<bool()>& going);
  /// In place of simulate(), where nothing that it judges comes of the run.
  void leave_out() { end("ok", ""); }
  /// In place of simulate() and judge(), what they would take [s].
  double expected_seconds();
  /// Of leave_out() and judge(), what they take [s].
  double judging_seconds();
  RowResult result() const { return result_; }
  const scenario::Traces& traces() const { return *traces_; }

 private:
  static constexpr std::size_t longest_note = 1000;
  void end(const std::string& status, const std::string& note);
  void add_coded();
  std::unique_ptr<CodedMetric> coded(const Metric& metric) const;
  /// Those whose steps are counted, or whose share is told, are there.
  void check_subsystems() const;
  void check_states() const;
  /// Those that metrics name are there.
  /// Of the metric that asks for an output which is not there.
  Place place_named_in(const std::string& sentence) const;
  void judge(const Metric& metric);
  void judge_otherwise(const Metric& metric);
  void time(const Metric& metric);
  /// And the formulas that wait for them.
  void judge_orders(const std::function<bool()>& going);
  void tell_order(const Metric& metric, const std::function<bool()>& going);
  void tell_stability(const Metric& metric);
  double counted(const Metric& metric) const;
  double indicated(const Metric& metric) const;
  void compare(const Metric& metric);
  void compute(const Metric& metric);
  void tell(const Metric& metric);
  double scale(const Metric& metric) const { return metric.scale ? value_of(*metric.scale, row_) : 1.0; }
  void judge_status();
  FileValues with_columns() const;
  void set(const std::string& name, double value) { result_.metrics[name] = value; }

  const RowRunner& all_;
  const FileValues& row_;
  std::vector<std::string> outputs_;
  bool finer_;
  scenario::Scenario scenario_;
  std::optional<scenario::Assembly> assembly_;
  std::optional<scenario::Traces> traces_;
  std::map<std::string, std::unique_ptr<CodedMetric>> coded_;
  Observers observers_;
  std::unique_ptr<Indicators> indicators_;  ///< null: no metric is of them
  Differences differences_;
  Timing judged_{};  ///< of the run that is judged
  std::optional<Timing> timing_;
  std::map<std::string, double> shares_;
  std::optional<stability::Stability> stability_;
  RowResult result_;
  std::optional<RowResult> halved_;
};

}  // namespace tandem::study
