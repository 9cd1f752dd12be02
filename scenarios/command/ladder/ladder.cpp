// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "ladder/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/scenario/comparison.hpp"

namespace tandem::scenario {
namespace {

bool has(const RungRun& run, const std::string& quantity) {
  if (!run.table) return false;
  const auto& names = run.table->names;
  return std::find(names.begin(), names.end(), quantity) != names.end();
}

/// The norm of a quantity itself, over the rows that count.
double magnitude(const text::TimeTable& table, const LadderQuantity& judged) {
  text::TimeTable zero = table;
  for (auto& column : zero.columns)
    for (double& value : column) value = 0.0;
  Measure measure = judged.measure;
  measure.shift = 0.0;
  const Difference d = compare(table, zero, {judged.quantity}, measure).columns[0];
  return measure.norm == Norm::rms ? d.rms : d.absolute;
}

/// In the output's unit, over the times that both cover, and by how much `a` is later.
std::pair<double, double> difference(const RungRun& a, const RungRun& b, const LadderQuantity& judged) {
  if (!has(a, judged.quantity) || !has(b, judged.quantity))
    return {std::numeric_limits<double>::quiet_NaN(), 0.0};
  const Comparison c = compare(*a.table, *b.table, {judged.quantity}, judged.measure);
  return {judged.measure.norm == Norm::rms ? c.columns[0].rms : c.columns[0].absolute, c.shift};
}

bool meets_all(const std::vector<LadderColumn>& columns, std::size_t rung) {
  return std::all_of(columns.begin(), columns.end(),
                     [&](const LadderColumn& c) { return c.from_richest[rung] <= c.judged.tolerance; });
}

/// Some quantity and some tolerance make this rung the simplest that meets it.
bool wins(const std::vector<LadderColumn>& columns, std::size_t rung) {
  return std::any_of(columns.begin(), columns.end(), [&](const LadderColumn& c) {
    const double own = c.from_richest[rung];
    const auto begin = c.from_richest.begin(), end = begin + static_cast<std::ptrdiff_t>(rung);
    return std::isfinite(own) && std::none_of(begin, end, [&](double simpler) { return simpler <= own; });
  });
}

}  // namespace

LadderColumn ladder_column(const std::vector<RungRun>& runs, const LadderQuantity& judged, double factor) {
  const RungRun& richest = runs.back();
  if (!has(richest, judged.quantity))
    refuse(judged.place, "the richest rung '" + richest.name + "' gives no " + judged.quantity +
                             (richest.failure.empty() ? "" : ": " + richest.failure));
  const double scale = judged.unit.empty() ? 1.0 / magnitude(*richest.table, judged) : factor;
  if (!std::isfinite(scale))
    refuse(judged.place, judged.quantity + " is 0 all the time in the richest rung '" + richest.name +
                             "'; a fraction needs a magnitude, give a unit");
  LadderColumn column{judged, {}, {}, {}};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const RungRun& next = runs[std::min(k + 1, runs.size() - 1)];
    const auto [from_richest, shift] = difference(runs[k], richest, judged);
    column.from_richest.push_back(scale * from_richest);
    column.to_next.push_back(scale * difference(runs[k], next, judged).first);
    column.shift.push_back(shift);
  }
  return column;
}

LadderVerdict ladder_verdict(const std::vector<LadderColumn>& columns) {
  const std::size_t last = columns[0].from_richest.size() - 1;
  LadderVerdict verdict;
  while (verdict.simplest < last && !meets_all(columns, verdict.simplest)) ++verdict.simplest;
  verdict.next_changes = std::any_of(columns.begin(), columns.end(), [&](const LadderColumn& c) {
    return !(c.to_next[verdict.simplest] <= c.judged.tolerance);
  });
  for (std::size_t k = 1; k < last; ++k)
    if (!wins(columns, k)) verdict.useless.push_back(k);
  for (std::size_t k = verdict.simplest + 1; k < last; ++k)
    if (!meets_all(columns, k)) verdict.worse.push_back(k);
  return verdict;
}

}  // namespace tandem::scenario
