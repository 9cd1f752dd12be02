// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ladder/ladder.hpp"

namespace tandem::scenario {
namespace {

std::string amount(const LadderQuantity& judged, double value) {
  if (std::isnan(value)) return "none";
  return judged.unit.empty() ? fmt::format("{:.3g} %", 100.0 * value)
                             : fmt::format("{:.3g} {}", value, judged.unit);
}

const char* norm_of(const LadderColumn& c) { return c.judged.measure.norm == Norm::rms ? "rms" : "max"; }

std::string table(const std::vector<RungRun>& runs, const std::vector<LadderColumn>& columns) {
  std::size_t width = 4;
  for (const RungRun& run : runs) width = std::max(width, run.name.size());
  std::string text = fmt::format("{:<{}}", "rung", width);
  for (const LadderColumn& c : columns) text += fmt::format("  {:>20}", c.judged.quantity);
  text += fmt::format("  {:>12}\n", "seconds");
  for (std::size_t k = 0; k < runs.size(); ++k) {
    text += fmt::format("{:<{}}", runs[k].name, width);
    for (const LadderColumn& c : columns) {
      const bool within = c.from_richest[k] <= c.judged.tolerance;
      text += fmt::format("  {:>18} {}", amount(c.judged, c.from_richest[k]), within ? ' ' : '*');
    }
    text += runs[k].seconds > 0.0 ? fmt::format("  {:>12.4g}\n", runs[k].seconds) : "\n";
  }
  return text;
}

/// "kart.pitch by 0.2 deg": what a rung has beyond the tolerances.
std::string excess(const std::vector<LadderColumn>& columns, const std::vector<double> LadderColumn::*of,
                   std::size_t rung) {
  std::vector<std::string> parts;
  for (const LadderColumn& c : columns) {
    const double value = (c.*of)[rung];
    if (std::isnan(value))
      parts.push_back("gives no " + c.judged.quantity);
    else if (value > c.judged.tolerance)
      parts.push_back(fmt::format("{} by {}", c.judged.quantity, amount(c.judged, value)));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string simplest_and_next(const std::vector<RungRun>& runs, const std::vector<LadderColumn>& columns,
                              const LadderVerdict& v) {
  const std::string& name = runs[v.simplest].name;
  std::string text;
  if (v.simplest + 1 == runs.size())
    text = fmt::format("only the richest, {}, is left; whether it is rich enough is not known\n", name);
  else
    text = fmt::format("simplest within the tolerances: {}\n", name);
  if (v.simplest > 0)
    text += fmt::format("the next simpler, {}, is not: {}\n", runs[v.simplest - 1].name,
                        excess(columns, &LadderColumn::from_richest, v.simplest - 1));
  else
    text += "there is no simpler one\n";
  if (v.simplest + 1 == runs.size()) return text;
  const std::string& next = runs[v.simplest + 1].name;
  return text + (v.next_changes ? fmt::format("the next richer, {}, differs from it: {}\n", next,
                                              excess(columns, &LadderColumn::to_next, v.simplest))
                                : fmt::format("the next richer, {}, changes nothing that matters\n", next));
}

}  // namespace

std::string ladder_text(const std::vector<RungRun>& runs, const std::vector<LadderColumn>& columns) {
  const LadderVerdict v = ladder_verdict(columns);
  std::vector<std::string> allowed;
  for (const LadderColumn& c : columns)
    allowed.push_back(c.judged.quantity + " " + amount(c.judged, c.judged.tolerance) +
                      (c.judged.measure.norm == Norm::rms ? " in rms" : ""));
  std::string text = table(runs, columns) + fmt::format("differences from {}; allowed: {} (*: beyond)\n",
                                                        runs.back().name, fmt::join(allowed, ", "));
  for (const RungRun& run : runs)
    if (!run.failure.empty()) text += fmt::format("{} failed: {}\n", run.name, run.failure);
  text += simplest_and_next(runs, columns, v);
  for (const LadderColumn& c : columns)
    for (std::size_t k = 0; k < runs.size(); ++k)
      if (c.shift[k] != 0.0)
        text += fmt::format("{}: {} is {:.3g} s {} as a whole\n", runs[k].name, c.judged.quantity,
                            std::abs(c.shift[k]), c.shift[k] > 0.0 ? "later" : "earlier");
  for (const LadderColumn& c : columns)
    if (columns.size() > 1)
      text += fmt::format("simplest for {} alone: {}\n", c.judged.quantity,
                          runs[ladder_verdict({c}).simplest].name);
  for (const std::size_t k : v.worse)
    text += fmt::format("{} is richer than {}, and yet not within: {}\n", runs[k].name, runs[v.simplest].name,
                        excess(columns, &LadderColumn::from_richest, k));
  for (const std::size_t k : v.useless)
    text += fmt::format("{} is of no use here: in each quantity a simpler one is as near\n", runs[k].name);
  for (std::size_t k = 0; k + 1 < runs.size(); ++k)
    for (std::size_t richer = k + 1; richer < runs.size(); ++richer)
      if (runs[richer].seconds > 0.0 && runs[richer].failure.empty() &&
          runs[k].seconds > 1.1 * runs[richer].seconds) {
        text += fmt::format("{} takes longer than {}, which is richer\n", runs[k].name, runs[richer].name);
        break;
      }
  return text;
}

std::string ladder_rows(const std::vector<RungRun>& runs, const std::vector<LadderColumn>& columns) {
  const auto number = [](double value) {
    return std::isnan(value) ? std::string() : fmt::format("{:.6g}", value);
  };
  std::string rows;
  for (const LadderColumn& c : columns)
    for (std::size_t k = 0; k < runs.size(); ++k) {
      const char* status = !runs[k].failure.empty()        ? "failed"
                           : std::isnan(c.from_richest[k]) ? "absent"
                                                           : "ok";
      rows += fmt::format("\"{}\",{},{},{},{},{},{:.6g},{:.6g},{},{}\n", runs[k].name, c.judged.quantity,
                          c.judged.unit.empty() ? "1" : c.judged.unit, norm_of(c), number(c.from_richest[k]),
                          number(c.to_next[k]), c.judged.tolerance, c.shift[k],
                          runs[k].seconds > 0.0 ? number(runs[k].seconds) : "", status);
    }
  return rows;
}

}  // namespace tandem::scenario
