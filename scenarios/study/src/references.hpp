// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "judged.hpp"
#include "over_time.hpp"
#include "scenes.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::study {

/// One reference for one set of values of the columns that it goes by.
struct ReferenceRun {
  const Reference* reference;
  const Table* table;  ///< one whose rows need it
  FileValues per;
  std::vector<std::string> columns;       ///< of the rows that need it
  std::vector<std::string> outputs = {};  ///< by the names in the study
  std::string failure = {};               ///< a sentence; empty: it is there
  OutputTables tables = {}, finer = {};
  std::map<std::string, std::string> units = {};

  std::string text() const;
};

/// The references that the rows of a study need.
class References {
 public:
  References(const Study& study, Scenes& scenes, const Builtins& builtins)
      : study_(study), scenes_(scenes), builtins_(builtins) {}

  /// Before they are made. Throws Error for a row that lacks a column in `per`.
  void need(const std::vector<const Metric*>& metrics, const Table& table, const FileValues& row);
  std::size_t size() const { return runs_.size(); }
  const ReferenceRun& run(std::size_t which) const { return *runs_[which]; }
  /// For one that another process has made.
  ReferenceRun& run(std::size_t which) { return *runs_[which]; }
  /// What one will take [s].
  double expected_seconds(std::size_t which);
  /// Reads or runs one: different ones at the same time. A run that fails is told in it; throws Error for
  /// what is wrong before.
  void make(std::size_t which, const std::function<bool()>& going);
  const ReferenceRun& of(const std::string& reference, const Table& table, const FileValues& row) const;
  /// What the expression of a metric names, for a row's run; all must outlive it.
  TableOf tables(const Metric& metric, const scenario::Traces& traces, const Table& table,
                 const FileValues& row) const;

 private:
  std::string key(const Reference& reference, const Table& table, const FileValues& row) const;
  void add_kept(const Kept& kept, const std::string& reference, std::vector<std::string>& to) const;
  void read(ReferenceRun& run) const;
  void simulate(ReferenceRun& run, const std::function<bool()>& going);
  OutputTables tables_of(ReferenceRun& run, const scenario::Scenario& scenario,
                         const std::function<bool()>& going) const;

  const Study& study_;
  Scenes& scenes_;
  const Builtins& builtins_;
  std::vector<std::unique_ptr<ReferenceRun>> runs_;
  std::map<std::string, ReferenceRun*> by_key_;
};

}  // namespace tandem::study
