// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/two_mass_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "charts/csv_table.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

const std::vector<std::string> sweep_columns = {
    "schedule",     "to_fast",         "to_slow",   "frequency_ratio", "position_error_exact",
    "energy_error", "amplitude_error", "exchanges", "status"};
const std::vector<std::string> work_columns = {
    "schedule",        "to_fast",   "to_slow", "frequency_ratio", "steps_per_cycle", "position_error_exact",
    "amplitude_error", "exchanges", "seconds", "status"};
const std::vector<std::string> trace_columns = {
    "frequency_ratio", "schedule", "to_fast", "to_slow", "time", "x1", "x1_exact", "energy_error"};

Scheme scheme_of(const CsvTable::Row& row) {
  return {row.text("schedule"), row.text("to_fast"), row.text("to_slow")};
}

bool failed_of(const CsvTable& table, std::size_t k) {
  const std::string& status = table[k].text("status");
  if (status == "ok" || status == "failed") return status == "failed";
  throw Error(ErrorCode::input_output, "file '" + table.file().string() + "', line " + std::to_string(k + 2) +
                                           ": status is something else; allowed is 'ok' or 'failed'");
}

Result result_of(const CsvTable& table, std::size_t k) {
  const CsvTable::Row row = table[k];
  Result r;
  r.scheme = scheme_of(row);
  r.frequency_ratio = row.positive("frequency_ratio");
  r.position_error = row.number("position_error_exact");
  r.amplitude_error = row.number("amplitude_error");
  r.exchanges = row.number("exchanges");
  r.failed = failed_of(table, k);
  return r;
}

/// A table without rows would give an empty chart.
CsvTable read_rows(const std::filesystem::path& file, const std::vector<std::string>& columns) {
  CsvTable table = CsvTable::read(file, columns);
  if (table.size() == 0) throw Error(ErrorCode::input_output, "file '" + file.string() + "', line 2: no row");
  return table;
}

}  // namespace

double Result::error() const {
  const double larger = std::max(position_error, std::abs(amplitude_error));
  return failed || std::isnan(position_error) || std::isnan(amplitude_error)
             ? std::numeric_limits<double>::infinity()
             : larger;
}

std::vector<Result> read_sweep(const std::filesystem::path& file) {
  const CsvTable table = read_rows(file, sweep_columns);
  std::vector<Result> results;
  for (std::size_t k = 0; k < table.size(); ++k) {
    results.push_back(result_of(table, k));
    results.back().energy_error = table[k].number("energy_error");
  }
  return results;
}

std::vector<Result> read_work(const std::filesystem::path& file) {
  const CsvTable table = read_rows(file, work_columns);
  std::vector<Result> results;
  for (std::size_t k = 0; k < table.size(); ++k) {
    Result& r = results.emplace_back(result_of(table, k));
    r.steps_per_cycle = table[k].positive("steps_per_cycle");
    r.seconds = r.failed ? table[k].number("seconds") : table[k].positive("seconds");
  }
  return results;
}

std::vector<Trace> read_traces(const std::filesystem::path& file) {
  const CsvTable table = read_rows(file, trace_columns);
  std::vector<Trace> traces;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const CsvTable::Row row = table[k];
    const double ratio = row.positive("frequency_ratio");
    const Scheme scheme = scheme_of(row);
    if (traces.empty() || traces.back().frequency_ratio != ratio || !(traces.back().scheme == scheme))
      traces.push_back({scheme, ratio, {}, {}, {}, {}});
    traces.back().time.push_back(row.number("time"));
    traces.back().x1.push_back(row.number("x1"));
    traces.back().x1_exact.push_back(row.number("x1_exact"));
    traces.back().energy_error.push_back(row.number("energy_error"));
  }
  return traces;
}

std::string name_of(const Scheme& s) {
  if (s.monolithic()) return s.schedule;
  return s.schedule + ", " + (s.to_fast == s.to_slow ? s.to_fast : s.to_fast + " / " + s.to_slow);
}

int equal_degree(const Scheme& s) {
  const bool equal = s.to_fast == s.to_slow && s.to_fast.size() == 9 && s.to_fast.starts_with("lagrange");
  return equal && s.to_fast.back() >= '0' && s.to_fast.back() <= '4' ? s.to_fast.back() - '0' : -1;
}

bool compared(const Scheme& s) { return !s.monolithic() && (s.to_fast == s.to_slow || s.to_slow == "mean"); }

}  // namespace tandem::charts
