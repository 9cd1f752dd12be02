// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "row_run.hpp"
#include "tandem/output_file.hpp"

namespace tandem::study {

/// The finished rows of a table, as lines of TABLE.csv, and in TABLE.part until it is whole.
class TableRows {
 public:
  /// fingerprint: of what makes them; rows of another one are not kept.
  TableRows(const Table& table, std::vector<std::string> header, std::filesystem::path folder,
            std::string fingerprint);

  /// Reads those of an earlier sweep, from TABLE.part, or from TABLE.csv. False: they are of another
  /// fingerprint.
  bool keep();
  /// Begins TABLE.part with those that are kept.
  void begin();
  bool has(const FileValues& row) const { return lines_.contains(key(row)); }
  std::size_t size() const { return lines_.size(); }
  /// As it stands in TABLE.csv.
  std::string line(const FileValues& row, const RowResult& result) const;
  /// From any thread.
  void add(const FileValues& row, const std::string& line);
  /// Writes TABLE.csv in the order of the study.
  void finish();
  /// When TABLE.csv and TABLE.json are there.
  void remove_part();

  std::filesystem::path file() const { return folder_ / (table_.name + ".csv"); }
  std::filesystem::path json() const { return folder_ / (table_.name + ".json"); }
  std::filesystem::path series() const { return folder_ / (table_.name + ".series.csv"); }
  std::filesystem::path part() const { return folder_ / (table_.name + ".part"); }

 private:
  std::string key(const FileValues& row) const;
  bool keep_part();
  bool keep_table();
  std::string first_line() const { return "rows of " + fingerprint_; }

  const Table& table_;
  std::vector<std::string> header_;
  std::filesystem::path folder_;
  std::string fingerprint_;
  std::mutex mutex_;
  std::map<std::string, std::string> lines_;  ///< by key
  std::unique_ptr<OutputFile> part_;
};

}  // namespace tandem::study
