// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "plan.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "row_key.hpp"

namespace tandem::study {
namespace {

constexpr std::size_t tried = 8;  ///< rows of a table that tell its time

std::size_t repetitions(const RowRunner& runner) {
  int most = 1;
  for (const Metric* metric : runner.metrics()) most = std::max(most, metric->repetitions);
  return static_cast<std::size_t>(most);
}

/// Returns what its rows will take [s], by some of them.
double plan_table(const Table& table, const RowRunner& runner, References& references,
                  std::vector<std::string>& lines) {
  lines.push_back(fmt::format("{}.csv: {} rows", table.name, table.rows.size()));
  double seconds = 0.0;
  std::size_t runs = 0, timed = 0;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const FileValues& row = table.rows[k];
    references.need(runner.metrics(), table, row);
    const bool is_tried = k * tried / table.rows.size() >= timed;
    double own = 0.0;
    if (const std::string why = runner.refusal(row, is_tried ? &own : nullptr); !why.empty()) {
      lines.push_back("  refused (" + row_text(table.columns, row) + "): " + why);
      continue;
    }
    ++runs;
    if (is_tried) seconds += own, ++timed;
  }
  return timed == 0 ? 0.0
                    : seconds * static_cast<double>(runs * repetitions(runner)) / static_cast<double>(timed);
}

}  // namespace

std::vector<std::string> plan(const Study& study, const std::deque<RowRunner>& runners,
                              References& references) {
  std::vector<std::string> lines;
  double of_rows = 0.0, of_references = 0.0;  // [s]
  for (std::size_t k = 0; k < runners.size(); ++k)
    of_rows += plan_table(study.tables[k], runners[k], references, lines);
  for (const Choice& choice : study.choices)
    lines.push_back(fmt::format("{}.csv: what {} chooses, judged by {}", choice.name, choice.by, choice.of));
  for (std::size_t k = 0; k < references.size(); ++k) {
    const ReferenceRun& run = references.run(k);
    lines.push_back(run.text() + (run.reference->floor ? ", and with half its steps" : ""));
    of_references += references.expected_seconds(k);
  }
  lines.push_back(
      fmt::format("about {:.3g} s for rows, without what their metrics take, and {:.3g} s for references, on "
                  "one processor",
                  of_rows, of_references));
  return lines;
}

}  // namespace tandem::study
