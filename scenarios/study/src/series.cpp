// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "row_key.hpp"
#include "tandem/charts/csv_table.hpp"

namespace tandem::study {
namespace {

/// Columns and numbers of each row that was written; of those that are not ok the columns alone.
std::vector<FileValues> results(const std::filesystem::path& file, const Table& table,
                                const std::vector<std::string>& metrics) {
  const auto csv = charts::CsvTable::read(file, {});
  std::vector<FileValues> rows = table.rows;
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (const std::string& name : metrics)
      if (csv[k].text("status") != "ok")
        break;
      else if (const double value = csv[k].number(name); std::isfinite(value))
        rows[k][name] = value;
  return rows;
}

}  // namespace

Series::Series(const Study& study, const Table& table, const References& references)
    : study_(study), table_(table), references_(references), columns_(study.columns_of_series(table)) {
  for (const Kept& kept : study.kept)
    if (kept.table == table.name) kept_.push_back(&kept);
}

std::string Series::header() const {
  std::string header;
  for (const std::string& column : columns_) header += (header.empty() ? "" : ",") + column;
  return header + '\n';
}

/// Rows, in the order of the table.
std::vector<std::size_t> Series::chosen(const Kept& kept, const std::vector<FileValues>& rows) const {
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (!kept.where || (is_known(*kept.where, rows[k]) && value_of(*kept.where, rows[k]) != 0.0))
      all.push_back(k);
  const std::string& by = kept.least.empty() ? kept.most : kept.least;
  if (by.empty()) return all;
  const auto value = [&](std::size_t k) { return std::get<double>(rows[k].at(by)); };
  std::map<std::string, std::size_t> best;
  for (const std::size_t k : all) {
    if (!rows[k].contains(by)) continue;
    const auto [it, is_first] = best.emplace(row_key(kept.per, rows[k]), k);
    if (!is_first && (kept.least.empty() ? value(k) > value(it->second) : value(k) < value(it->second)))
      it->second = k;
  }
  std::erase_if(all, [&](std::size_t k) {
    const auto it = best.find(row_key(kept.per, rows[k]));
    return it == best.end() || it->second != k;
  });
  return all;
}

std::optional<std::string> Series::text(const std::filesystem::path& file, const RowRunner& runner,
                                        const std::function<bool()>& going) {
  std::string text = header();
  const auto rows = results(file, table_, table_.metrics);
  for (const Kept* kept : kept_)
    for (const std::size_t k : chosen(*kept, rows)) {
      const auto keep = [&](const scenario::Traces& traces) { add(*kept, table_.rows[k], traces, text); };
      if (!runner.trace(table_.rows[k], *kept, going, keep)) return {};
    }
  return text;
}

void Series::add(const Kept& kept, const FileValues& row, const scenario::Traces& traces, std::string& to) {
  const std::vector<double>& times = traces.of(kept.outputs[0]).times;
  Followed followed(times);
  std::vector<std::string> names;
  for (const std::string& output : kept.outputs)
    followed.add(traces.of(output), output), names.push_back(output), units_[output] = traces.unit(output);
  if (!kept.against.empty()) {
    const ReferenceRun& reference = references_.of(kept.against, table_, row);
    if (reference.failure.empty())
      for (const std::string& output : kept.outputs)
        followed.add(reference.tables.at(output), output), names.push_back(output + "." + kept.against);
  }
  std::vector<OverTime> drifts;
  for (const std::string& drift : kept.metrics) {
    const Metric& metric = study_.metric(drift);
    drifts.emplace_back(metric, references_.tables(metric, traces, table_, row), row, times);
  }
  const std::string head = row_key(table_.columns, row) + ',' + charts::csv_cell(cell_of(kept.name)) + ',';
  double next = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < times.size(); ++k) {
    std::map<std::string, double> values;
    followed.move_to(k);
    for (std::size_t c = 0; c < names.size(); ++c) values[names[c]] = followed.values()[c];
    for (std::size_t d = 0; d < drifts.size(); ++d)
      if (const auto value = drifts[d].at(k)) values[kept.metrics[d]] = *value / drifts[d].divisor();
    if (times[k] < next) continue;
    next = times[k] + kept.every * (1.0 - 1e-9);
    to += head + cell_of(times[k]);
    for (std::size_t c = table_.columns.size() + 2; c < columns_.size(); ++c) {
      const auto it = values.find(columns_[c]);
      to += ',' + (it == values.end() || !std::isfinite(it->second) ? "" : cell_of(it->second));
    }
    to += '\n';
  }
}

}  // namespace tandem::study
