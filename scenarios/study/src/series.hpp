// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "references.hpp"
#include "row_run.hpp"

namespace tandem::study {

/// TABLE.series.csv: the outputs over time of the runs that a table keeps.
class Series {
 public:
  Series(const Study& study, const Table& table, const References& references);
  bool empty() const { return kept_.empty(); }

  /// Runs them again, by the results of the table's rows, which stand in `file`. Nothing: `going` said no.
  std::optional<std::string> text(const std::filesystem::path& file, const RowRunner& runner,
                                  const std::function<bool()>& going);
  /// Of its outputs, after text().
  const std::map<std::string, std::string>& units() const { return units_; }

 private:
  std::string header() const;
  std::vector<std::size_t> chosen(const Kept& kept, const std::vector<FileValues>& rows) const;
  void add(const Kept& kept, const FileValues& row, const scenario::Traces& traces, std::string& to);

  const Study& study_;
  const Table& table_;
  const References& references_;
  std::vector<const Kept*> kept_;
  std::vector<std::string> columns_;  ///< of the file
  std::map<std::string, std::string> units_;
};

}  // namespace tandem::study
