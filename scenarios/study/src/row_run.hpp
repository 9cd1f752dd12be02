// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>

#include "references.hpp"
#include "tandem/identification/models.hpp"
#include "tandem/study/coded_metric.hpp"

namespace tandem::study {

/// What a row has beside its columns.
struct RowResult {
  FileValues metrics;  ///< by name, with METRIC.shift and METRIC.floor; those that are known
  std::string status, note;
};

/// Runs rows of a table, at the same time if wanted.
class RowRunner {
 public:
  RowRunner(const Study& study, const Table& table, Scenes& scenes, const References& references,
            const Builtins& builtins, const CodedMetrics& coded);

  /// Nothing: `going` said no. Throws Error for what is wrong with the study.
  std::optional<RowResult> run(const FileValues& row, const std::function<bool()>& going) const;
  /// Runs it again for outputs over time that are kept. False: `going` said no.
  bool trace(const FileValues& row, const Kept& kept, const std::function<bool()>& going,
             const std::function<void(const scenario::Traces&)>& keep) const;
  /// Up to the first step; the sentence of a row that is refused, else empty. seconds: gets what the run will
  /// take, where it is not null.
  std::string refusal(const FileValues& row, double* seconds = nullptr) const;
  const std::vector<const Metric*>& metrics() const { return metrics_; }
  /// By metric, as far as a run that began has told them.
  std::map<std::string, std::string> units(const FileValues& row) const;

 private:
  class OneRun;
  std::optional<RowResult> run_once(const FileValues& row, const std::function<bool()>& going) const;
  bool needs_run() const;
  bool holds(const FileValues& row, const RowResult& result) const;
  double runs_of_row() const;  ///< that a search makes, about; else 1
  std::optional<RowResult> search(const FileValues& row, const std::function<bool()>& going) const;
  const Study& study_;
  const Table& table_;
  Scenes& scenes_;
  const References& references_;
  std::unique_ptr<identification::Models> models_;  ///< that stand in the subsystems' places; null: none do
  const Builtins builtins_;
  const CodedMetrics& coded_;
  std::vector<const Metric*> metrics_;
  std::vector<std::string> outputs_;
};

}  // namespace tandem::study
